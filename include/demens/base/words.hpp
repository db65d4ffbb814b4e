#pragma once

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

} // namespace demens
