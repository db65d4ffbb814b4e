// What is told about a wrong input: where it is, what is wrong, and what would be right.
#include "ensemble/input/campaign_input.hpp"

#include "tests/unit/ensemble/input/test_rigs.hpp"

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace demens::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

//! The message about the good campaign with one piece replaced.
std::string message_with(std::string const& piece, std::string const& by)
{
    return message_about(replaced(good_campaign(), piece, by));
}

std::string const youngs_factor = "path = \"material.quartz.youngs_modulus\"\nlower = 1e6\nupper = 1e8";

TEST(BadInput, GoodCampaignIsAccepted)
{
    EXPECT_EQ(message_about(good_campaign()), "");
}

TEST(BadInput, MisspeltKey)
{
    EXPECT_EQ(message_with("restitution = 0.3719", "restituton = 0.3719"),
              "test.toml:17: contact.quartz_quartz.restituton = 0.3719: unknown key; did you mean "
              "\"restitution\"?");
}

TEST(BadInput, UnknownKeyThatResemblesNothing)
{
    EXPECT_THAT(message_with("density = 700", "density = 700\ncolour = \"brown\""),
                AllOf(StartsWith("test.toml:12: material.wood_dry.colour = "),
                      HasSubstr("known: density, youngs_modulus, poisson_ratio")));
}

TEST(BadInput, WrongTypes)
{
    EXPECT_THAT(message_with("density = 2604.1", "density = \"heavy\""),
                AllOf(StartsWith("test.toml:6: material.quartz.density = "), HasSubstr("heavy"),
                      HasSubstr("must be a number, not a word (density [kg/m^3])")));
    EXPECT_THAT(message_with("layers = 3", "layers = 3.5"),
                HasSubstr("experiment.bench.layers = 3.5: must be a whole number, not a number"));
    EXPECT_THAT(message_with("periodic = true", "periodic = 1"),
                HasSubstr("must be true or false, not a whole number"));
    EXPECT_THAT(message_with("[material.wood_dry]\ndensity = 700", "[material]\nwood_dry = 700"),
                HasSubstr("must be a table [material.wood_dry], not a whole number"));
    EXPECT_THAT(message_with("diameters_mm = [12.7, 25.4]", "diameters_mm = [12.7, \"x\"]"),
                HasSubstr("must be a list of finite numbers"));
    EXPECT_THAT(
        message_with("[[experiment]]\nname = \"drop\"", "[[experiment]]\ntarget = 3\nname = \"drop\""),
        HasSubstr("3"));
}

TEST(BadInput, OutOfRange)
{
    EXPECT_THAT(message_with("poisson_ratio = 0.3", "poisson_ratio = 0.5"),
                HasSubstr("material.quartz.poisson_ratio = 0.5: must be at least 0 and at most 0.499"));
    EXPECT_THAT(message_with("scale = 0.3 }", "scale = 0 }"), HasSubstr("scale = 0: must be greater than 0"));
    EXPECT_THAT(message_with("kinetic_friction = 0.8", "kinetic_friction = -0.5"),
                HasSubstr("must be at least 0"));
    EXPECT_THAT(message_with("density = 700", "density = nan"), HasSubstr("must be a finite number"));
    for (auto const* density : {"9007199254740993", "-9007199254740993", "9223372036854775807"})
        EXPECT_THAT(message_with("density = 700", std::string("density = ") + density),
                    HasSubstr(std::string(density) + ": a whole number beyond 2^53 is not kept exactly"));
    EXPECT_THAT(message_with("diameters_mm = [12.7, 25.4]", "diameters_mm = [12.7, 9007199254740993]"),
                HasSubstr("9007199254740993: a whole number beyond 2^53"));
    EXPECT_THAT(message_with("seed = 7", "seed = -7"), HasSubstr("campaign.seed = -7: must be at least 0"));
}

TEST(BadInput, MissingKey)
{
    EXPECT_THAT(message_with("mass_kg = 25.75\n", ""),
                AllOf(StartsWith("test.toml:35: experiment.bench"),
                      HasSubstr("the key \"mass_kg\" is missing; give")));
    EXPECT_THAT(message_with("[material.wood_dry]\ndensity = 700", "[material.wood_dry]"),
                AllOf(StartsWith("test.toml:10: material.wood_dry: "), HasSubstr("\"density\" is missing")));
    EXPECT_THAT(message_with("rig = \"plate\"\n", ""), HasSubstr("the key \"rig\" is missing"));
    EXPECT_THAT(message_with("upper = 1e8\n", ""), HasSubstr("the key \"upper\" is missing"));
}

TEST(BadInput, BadChoiceAndNames)
{
    EXPECT_THAT(message_with("\"epsd\"", "\"epds\""),
                HasSubstr("rolling = \"epds\": must be one of none, constant_torque, viscous, epsd, epsd2"));
    EXPECT_THAT(message_with("rig = \"hopper\"", "rig = \"hoper\""),
                HasSubstr("there is no such rig; did you mean \"hopper\"?"));
    EXPECT_THAT(message_with("material = \"quartz\"", "material = \"quarz\""),
                HasSubstr("there is no [material.quarz]; did you mean \"quartz\"?"));
    EXPECT_THAT(message_with("sizes = \"half_inch\"", "sizes = \"half_inh\""),
                HasSubstr("there is no [size_distribution.half_inh]; did you mean \"half_inch\"?"));
    EXPECT_THAT(message_with("name = \"bench\"", "name = \"on the bench\""),
                HasSubstr("must begin with a letter"));
    EXPECT_THAT(message_with("name = \"drop\"", "name = \"bench\""),
                HasSubstr("two experiments have this name"));
}

TEST(BadInput, CoefficientsOfLaws)
{
    EXPECT_THAT(message_with("rolling_friction = 0.2\n", ""),
                AllOf(StartsWith("test.toml:13: contact.quartz_quartz: "),
                      HasSubstr("rolling = \"epsd\" needs the key rolling_friction, which is missing")));
    EXPECT_THAT(message_with("allow_attraction = false", "cohesion = \"jkr\""),
                HasSubstr("cohesion = \"jkr\" needs the key surface_energy, which is missing"));
    EXPECT_THAT(message_with("restitution = 0.3719", "restitution = 0"),
                HasSubstr("restitution = 0: must be at least 0.01 and at most 1"));
    EXPECT_THAT(message_with("restitution = 0.3719", "restitution = 1.1"),
                HasSubstr("restitution = 1.1: must be at least 0.01 and at most 1"));
    EXPECT_THAT(message_with("static_friction = 0.7", "static_friction = -0.7"),
                HasSubstr("static_friction = -0.7: must be at least 0"));
}

TEST(BadInput, PairsOfMaterials)
{
    EXPECT_THAT(message_with("[contact.wood_dry_quartz]", "[contact.wood_dry_quarz]"),
                AllOf(StartsWith("test.toml:22: contact.wood_dry_quarz: "),
                      HasSubstr("did you mean \"wood_dry_quartz\"?")));
    EXPECT_THAT(
        message_with("[size_distribution.half_inch]",
                     "[contact.quartz_wood_dry]\nrestitution = 0.3\nstatic_friction = 0.1\n\n"
                     "[size_distribution.half_inch]"),
        AllOf(StartsWith("test.toml:27: "), HasSubstr("same pair"), HasSubstr("[contact.wood_dry_quartz]")));
    auto ambiguous = replaced(good_campaign(), "[material.wood_dry]",
                              "[material.dry_quartz]\ndensity = 1\n[material.wood]\n"
                              "density = 1\n[material.wood_dry]");
    EXPECT_THAT(message_about(ambiguous), HasSubstr("rename a material"));
    EXPECT_THAT(message_with("kinetic_friction = 0.8", "kinetic_friction = 0.95"),
                HasSubstr("give kinetic <= static"));
}

TEST(BadInput, SizeDistributions)
{
    EXPECT_THAT(message_with("[0.0, 1.0]", "[0.0, 0.5, 1.0]"),
                HasSubstr("has 3 values where diameters_mm has 2"));
    EXPECT_THAT(message_with("[0.0, 1.0]", "[0.0, 0.9]"),
                HasSubstr("last cumulative mass fraction must be 1"));
    EXPECT_THAT(message_with("[0.25, 0.75]", "[0.25, 0.7]"),
                AllOf(StartsWith("test.toml:31: size_distribution.two: "), HasSubstr("must sum to 1")));
    EXPECT_THAT(message_with("classes_mm = [10, 20]", "diameters_mm = [10, 20]"), HasSubstr("needs either"));
    EXPECT_THAT(message_with("classes_mm = [10, 20]\n", ""), HasSubstr("the key \"classes_mm\" is missing"));
}

TEST(BadInput, TargetForAResponseThatTheRigDoesNotHave)
{
    EXPECT_THAT(message_with("target.flow_kg_s", "target.flow_kg"),
                AllOf(StartsWith("test.toml:46: experiment.bench.target.flow_kg"),
                      HasSubstr("the rig hopper has no such response; did you mean \"flow_kg_s\"?")));
    EXPECT_THAT(message_with("target.rebound", "target.angle_deg"),
                HasSubstr("the rig plate has no such response; known: rebound"));
}

TEST(BadInput, FactorPathThatNamesNothing)
{
    EXPECT_EQ(message_with("contact.quartz_quartz.static_friction", "contact.quartz_quarz.static_friction"),
              "test.toml:55: factor[1].path = \"contact.quartz_quarz.static_friction\": names nothing in "
              "this input; did "
              "you mean \"contact.quartz_quartz.static_friction\"?");
    EXPECT_THAT(message_with(youngs_factor, "path = \"experiment.masskg\"\nlower = 1\nupper = 2"),
                HasSubstr("did you mean \"experiment.mass_kg\"?"));
    EXPECT_THAT(message_with(youngs_factor, "path = \"experiment.bench.layers\"\nlower = 1\nupper = 2"),
                HasSubstr("is not a number that can be varied continuously"));
}

TEST(BadInput, FactorBounds)
{
    EXPECT_THAT(message_with("lower = 0.1\nupper = 1.2", "lower = 1.2\nupper = 0.1"),
                AllOf(StartsWith("test.toml:56: factor[1].lower = 1.2: "),
                      HasSubstr("must be below upper = 0.1"), HasSubstr("wrong way round?")));
    EXPECT_THAT(message_with("lower = 1e6\nupper = 1e8", "lower = -1\nupper = 1e8"),
                HasSubstr("material.quartz.youngs_modulus must be at least 1"));
    EXPECT_THAT(message_with("path = \"material.quartz.youngs_modulus\"\nlower = 1e6\nupper = 1e8",
                             "path = \"experiment.drop.speed_m_s\"\nlower = 0\nupper = 3"),
                HasSubstr("must be greater than 0 for scale = \"log\""));
    EXPECT_THAT(message_with(youngs_factor, "path = \"experiment.slot_mm\"\nlower = 10\nupper = 501"),
                HasSubstr("upper = 501: experiment.slot_mm must be at least 1 and at most 500"));
}

TEST(BadInput, FactorsMustDiffer)
{
    EXPECT_THAT(message_with(youngs_factor,
                             "path = \"contact.quartz_quartz.static_friction\"\nname = \"b\"\nlower = "
                             "0.1\nupper = 1"),
                HasSubstr("sets the same number"));
    EXPECT_THAT(message_with(youngs_factor,
                             "path = \"contact.quartz_wood_dry.static_friction\"\nname = \"mu_k\"\nlower = "
                             "0.1\nupper = 1"),
                HasSubstr("is called mu_k too; give one of them another name"));
}

TEST(BadInput, AllFaultsOfAFileAreTold)
{
    auto const file =
        std::filesystem::temp_directory_path() / ("demens-faults-" + std::to_string(getpid()) + ".toml");
    auto text = replaced(good_campaign(), "restitution = 0.3719", "restituton = 0.3719");
    text = replaced(text, youngs_factor, youngs_factor + "\nscales = \"log\"");
    std::ofstream(file) << text;
    std::string message;
    try {
        ensemble::CampaignInput::from_file(file, rigs());
    } catch (InputError const& error) {
        message = error.what();
    }
    std::filesystem::remove(file);
    EXPECT_THAT(message, AllOf(HasSubstr("restituton = 0.3719: unknown key; did you mean \"restitution\"?\n"),
                               HasSubstr("scales = \"log\": unknown key; did you mean \"scale\"?")));
}

TEST(BadInput, Constraints)
{
    EXPECT_THAT(message_with("mu_k <= static_friction", "mu_k <= static_fricton"),
                AllOf(HasSubstr("constraint[1].expression = "), HasSubstr("mu_k <= static_fricton"),
                      HasSubstr("did you mean \"static_friction\"?")));
    EXPECT_THAT(message_with("mu_k <= static_friction", "mu_k * static_friction <= 1"),
                HasSubstr("is not linear"));
    EXPECT_THAT(message_with("mu_k <= static_friction", "mu_k"), HasSubstr("has no <= or >="));
    EXPECT_THAT(message_with("mu_k <= static_friction", "mu_k >= 1.3"),
                HasSubstr("holds nowhere within the bounds"));
}

TEST(BadInput, CornersThatNoRigCanRun)
{
    EXPECT_THAT(message_with("[[constraint]]\nexpression = \"mu_k <= static_friction\"\n", ""),
                AllOf(StartsWith("test.toml:35: experiment.bench: "),
                      HasSubstr("static_friction = 0.1, mu_k = 1.2"), HasSubstr("add a [[constraint]]")));
    EXPECT_THAT(message_with(youngs_factor, "path = \"experiment.mass_kg\"\nlower = 50\nupper = 150"),
                AllOf(HasSubstr("mass_kg = 150"), HasSubstr("more than the box holds"),
                      HasSubstr("narrow the bounds")));
    EXPECT_EQ(message_with("mass_kg = 25.75", "mass_kg = 250"),
              "test.toml:35: experiment.bench: the rig hopper cannot run this: mass_kg is more than the box "
              "holds; at "
              "most 100");
}

TEST(BadInput, SectionsThatDoNotFitTogether)
{
    EXPECT_THAT(message_with("points = 12", "points = 60"),
                HasSubstr("60 design points need 180 runs (3 each)"));
    EXPECT_THAT(
        message_with("kind = \"latin_hypercube\"\npoints = 12", "kind = \"table\"\ntable = [[0.5, 0.4]]"),
        HasSubstr("row 1 (0.5, 0.4) has 2 values; there are 3 factors"));
    EXPECT_THAT(message_with("kind = \"latin_hypercube\"\npoints = 12",
                             "kind = \"table\"\ntable = [[0.5, 0.6, 1e7]]"),
                HasSubstr("breaks the constraint \"mu_k <= static_friction\""));
    EXPECT_THAT(message_with("kind = \"latin_hypercube\"", "kind = \"sobol\"\nlevels = 3"),
                HasSubstr("is not used by kind = \"sobol\", only by full_factorial, d_optimal"));
    EXPECT_THAT(message_with("[[constraint]]", "[constraint]"),
                HasSubstr("constraint: must be a list of tables: write [[constraint]] in front of each"));
}

TEST(BadInput, NotToml)
{
    EXPECT_THAT(message_with("seed = 7", "seed = "),
                AllOf(StartsWith("test.toml:3: "), HasSubstr("not TOML")));
    EXPECT_THAT(message_with("seed = 7", "seed = 7\nseed = 8"),
                AllOf(StartsWith("test.toml:4: "), HasSubstr("seed")));
}

//! No text makes the reader do anything but read or refuse.
TEST(BadInput, EveryTruncationIsReadOrRefused)
{
    auto const text = good_campaign();
    int refused = 0;
    for (std::size_t size = 0; size < text.size(); ++size)
        refused += !message_about(text.substr(0, size)).empty();
    EXPECT_GT(refused, static_cast<int>(text.find("[[constraint]]"))) << "needs all that stands before";
    EXPECT_LT(refused, static_cast<int>(text.size())) << "sections at the end may be left out";
}

TEST(BadInput, NoTargetMeansNoSearch)
{
    auto text = good_campaign();
    for (std::string const name : {"angle_deg", "flow_kg_s", "rebound"})
        text = replaced(text, "target." + name, "#");
    EXPECT_THAT(message_about(text), HasSubstr("no experiment has a target"));
    EXPECT_EQ(message_about(replaced(text, "waves = 10", "waves = 0")), "");
}

TEST(BadInput, FileThatIsNotThere)
{
    try {
        ensemble::CampaignInput::from_file("/nonexistent/campaign.toml", rigs());
        FAIL() << "a file that does not exist was read";
    } catch (InputError const& error) {
        EXPECT_EQ(std::string(error.what()),
                  "/nonexistent/campaign.toml: cannot be read; give a campaign's TOML file");
    }
}

//! Every `key =` and `[section` of the good campaign, misspelt in one place at a time.
TEST(BadInput, EveryKeyMisspeltSuggestsTheRightOne)
{
    auto const text = good_campaign();
    int tried = 0;
    std::size_t begin = 0;
    while (begin < text.size()) {
        auto const end = text.find('\n', begin);
        auto const line = text.substr(begin, end - begin);
        auto const try_key = [&](std::size_t at, std::string const& key) {
            auto misspelt = text;
            misspelt.insert(at + key.size() - 1, 1, 'q'); // before the last letter
            auto const message = message_about(misspelt);
            EXPECT_THAT(message, HasSubstr("\"" + key + "\"")) << line;
            EXPECT_THAT(message, StartsWith("test.toml:")) << line;
            ++tried;
        };
        if (line.starts_with("[")) {
            auto const first = line.find_first_not_of('[');
            auto const key = line.substr(first, line.find_first_of(".]") - first);
            try_key(begin + first, key);
        } else if (auto const equals = line.find(" = "); equals != std::string::npos) {
            auto const dot = line.rfind('.', equals);
            auto const first = dot == std::string::npos ? 0 : dot + 1;
            try_key(begin + first, line.substr(first, equals - first));
            for (std::string const member : {"value", "scale", "sd", "tolerance"})
                if (auto const at = line.find(member + " = ", equals); at != std::string::npos)
                    try_key(begin + at, member);
        }
        begin = end + 1;
    }
    EXPECT_GT(tried, 70);
}

} // namespace
} // namespace demens::test
