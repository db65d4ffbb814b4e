// Completion for shells and the manual page, made of the command line as it is defined.
#include "app/command.hpp"

#include "demens/base/error.hpp"
#include "ensemble/version.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace demens::cli {
namespace {

std::vector<CLI::App const*> subcommands_of(CLI::App const& command)
{
    std::vector<CLI::App const*> all;
    for (auto const* sub : command.get_subcommands([](auto const*) { return true; }))
        all.push_back(sub);
    return all;
}

//! `--output`, `-o` and so on, of a command alone.
std::vector<std::string> flags_of(CLI::App const& command)
{
    std::vector<std::string> flags;
    for (auto const* option : command.get_options())
        for (auto const& name : option->get_lnames())
            flags.push_back("--" + name);
    return flags;
}

void add_bash_cases(std::string& script, CLI::App const& command, std::string const& words)
{
    std::vector<std::string> names = flags_of(command);
    for (auto const* sub : subcommands_of(command))
        names.push_back(sub->get_name());
    script += fmt::format("        \"{}\") words=\"{}\" ;;\n", words, fmt::join(names, " "));
    for (auto const* sub : subcommands_of(command))
        add_bash_cases(script, *sub, words.empty() ? sub->get_name() : words + " " + sub->get_name());
}

//! Names of commands and options, then files; the words before the cursor say of which command.
std::string bash_completion(CLI::App const& program)
{
    std::string script = "# bash completion for demens; to use it: source <(demens completion)\n"
                         "_demens()\n{\n"
                         "    local word=${COMP_WORDS[COMP_CWORD]} command= words= k\n"
                         "    for ((k = 1; k < COMP_CWORD; ++k)); do\n"
                         "        case ${COMP_WORDS[k]} in -*|*.*|*/*) ;; *) command=\"${command:+$command "
                         "}${COMP_WORDS[k]}\" ;; esac\n"
                         "    done\n"
                         "    case $command in\n";
    add_bash_cases(script, program, "");
    return script +
           "    esac\n"
           "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\"; compgen -f -- \"$word\")\n"
           "}\n"
           "complete -o filenames -F _demens demens\n";
}

//! Text in which troff sees no commands.
std::string roff(std::string const& text)
{
    std::string escaped;
    for (char const c : text) {
        if (c == '\\')
            escaped += "\\e";
        else if (c == '-')
            escaped += "\\-";
        else if ((c == '.' || c == '\'') && (escaped.empty() || escaped.back() == '\n'))
            escaped += std::string("\\&") + c;
        else
            escaped += c;
    }
    return escaped;
}

void add_section(std::string& page, CLI::App const& command, std::string const& name)
{
    page += fmt::format(".SS {}\n{}\n", roff(name), roff(command.get_description()));
    for (auto const* option : command.get_options()) {
        auto const text = option->nonpositional() ? option->get_name(false, true) : option->get_name(true);
        if (text.find("--help") == std::string::npos)
            page += fmt::format(".TP\n.B {}\n{}\n", roff(text), roff(option->get_description()));
    }
    for (auto const* sub : subcommands_of(command))
        add_section(page, *sub, name + " " + sub->get_name());
}

std::string manual_page(CLI::App const& program)
{
    auto page = fmt::format(".TH DEMENS 1 \"\" \"demens {}\"\n.SH NAME\ndemens \\- {}\n.SH SYNOPSIS\n"
                            ".B demens\n[COMMAND] [OPTIONS] FILE\n.br\n.B mpirun\n\\-n N demens FILE\n"
                            ".SH COMMANDS\n",
                            ensemble::program_version, roff(program.get_description()));
    for (auto const* sub : subcommands_of(program))
        add_section(page, *sub, sub->get_name());
    page += ".SH NOTES\n.nf\n" + roff(program.get_footer()) + "\n.fi\n";
    return page;
}

} // namespace

void add_shell_help(CLI::App& program, Action& action)
{
    auto shell = std::make_shared<std::string>("bash");
    auto* completion = program.add_subcommand(
        "completion", "print what completes its commands in a shell: source <(demens completion)");
    completion->add_option("SHELL", *shell,
                           "bash (zsh reads it too, after: autoload bashcompinit; bashcompinit)");
    completion->callback([shell, &program, &action] {
        action = [shell, &program] {
            if (*shell != "bash" && *shell != "zsh")
                throw InputError(fmt::format("there is no completion for {}; known: bash, zsh", *shell));
            fmt::print("{}", bash_completion(program));
            return success;
        };
    });
    auto* manual = program.add_subcommand("man", "print the manual page: demens man | man -l -");
    manual->callback([&program, &action] {
        action = [&program] {
            fmt::print("{}", manual_page(program));
            return success;
        };
    });
}

} // namespace demens::cli
