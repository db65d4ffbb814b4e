#include "gap/rehearsal/truth.hpp"

#include "demens/base/error.hpp"

#include <array>
#include <fmt/format.h>
#include <openssl/evp.h>

namespace demens::gap {

nlohmann::json json_of(CaseTruth const& truth)
{
    return {{"case", truth.name},           {"kind", word_for(truth.kind)},
            {"effects", truth.effects},     {"amplitudes", truth.amplitudes},
            {"strengths", truth.strengths}, {"factors", truth.factors}};
}

CaseTruth truth_of(nlohmann::json const& json)
{
    try {
        auto const* kind = find_word<CaseKind>(json.at("kind").get<std::string>());
        if (!kind)
            throw InputError(fmt::format("\"{}\" is no kind of case", json.at("kind").get<std::string>()));
        return {json.at("case"),   *kind, json.at("effects"), json.at("amplitudes"), json.at("strengths"),
                json.at("factors")};
    } catch (nlohmann::json::exception const& error) {
        throw InputError(fmt::format("this is no truth of a rehearsed case: {}", error.what()));
    }
}

std::string seal_of(std::string const& salt, CaseTruth const& truth)
{
    auto const text = salt + json_of(truth).dump();
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
    unsigned int length = 0;
    if (EVP_Digest(text.data(), text.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1)
        throw std::runtime_error("SHA-256 failed");
    std::string digits;
    for (unsigned int i = 0; i < length; ++i)
        digits += fmt::format("{:02x}", digest[i]);
    return digits;
}

} // namespace demens::gap
