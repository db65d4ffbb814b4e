#pragma once

#include "demens/base/error.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace demens {

//! A value of an enum and the word that stands for it in files.
template <class Enum>
struct Word
{
    Enum value;
    char const* text;
};

//! All words of an enum, once; specialised beside the enum.
template <class Enum>
std::vector<Word<Enum>> const& words_of();

//! The word for a value.
template <class Enum>
char const* word_for(Enum value)
{
    for (auto const& word : words_of<Enum>())
        if (word.value == value)
            return word.text;
    return "unknown";
}

//! The value that a word stands for, or null.
template <class Enum>
Enum const* find_word(std::string_view text)
{
    for (auto const& word : words_of<Enum>())
        if (word.text == text)
            return &word.value;
    return nullptr;
}

//! The words alone, for help and messages.
template <class Enum>
std::vector<std::string> texts_of()
{
    std::vector<std::string> texts;
    for (auto const& word : words_of<Enum>())
        texts.emplace_back(word.text);
    return texts;
}

// The same with a table at hand, for words that one file alone knows.

template <class Enum, std::size_t count>
std::vector<std::string> texts_of(std::array<Word<Enum>, count> const& words)
{
    std::vector<std::string> texts;
    for (auto const& word : words)
        texts.emplace_back(word.text);
    return texts;
}

template <class Enum, std::size_t count>
char const* word_for(std::array<Word<Enum>, count> const& words, Enum value)
{
    for (auto const& word : words)
        if (word.value == value)
            return word.text;
    return "unknown";
}

//! \throws InputError for a text that is none of the words
template <class Enum, std::size_t count>
Enum read_word(std::array<Word<Enum>, count> const& words, std::string const& text)
{
    std::string all;
    for (auto const& word : words) {
        if (text == word.text)
            return word.value;
        all += (all.empty() ? "" : ", ") + std::string(word.text);
    }
    throw InputError("\"" + text + "\" is none of " + all);
}

} // namespace demens
