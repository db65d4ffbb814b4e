#include "ensemble/input/file_source.hpp"

#include "demens/base/error.hpp"

#include <fmt/format.h>
#include <fstream>
#include <iterator>

namespace demens::ensemble::input {

FileSource files_beside(std::filesystem::path const& file)
{
    return [folder = file.parent_path()](std::string const& name) {
        auto const path = folder / name;
        std::ifstream stream(path, std::ios::binary);
        if (!stream || std::filesystem::is_directory(path))
            throw InputError(fmt::format(
                "{} cannot be read; give a file, relative to the folder of the TOML file", path.string()));
        return std::string{std::istreambuf_iterator<char>(stream), {}};
    };
}

FileSource stored_files(rig::Files files)
{
    return [files = std::move(files)](std::string const& name) {
        auto const found = files.find(name);
        if (found == files.end())
            throw InputError(fmt::format("the file {} is not stored with this input", name));
        return *found->second;
    };
}

std::string no_files(std::string const& name)
{
    throw InputError(fmt::format("the file {} cannot be read here, since the input is no file itself", name));
}

} // namespace demens::ensemble::input
