#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace noonmark {

/// A passage that two texts print differently.
struct WordDifference {
    std::string before;    ///< the words that precede it in both
    std::string recorded;  ///< empty: nothing
    std::string computed;
    bool hasFigure = false;  ///< a word with a digit is among them
};

struct WordComparison {
    std::size_t figures = 0;  ///< words with a digit in the recorded text
    std::vector<WordDifference> differences;
};

/// Compares the words of two printed texts, in order. Passages are matched again where three words agree,
/// after at most 400 words. How long a computation took ("0.1 s in total") is not compared. Cost: linear in
/// texts that agree.
WordComparison compareWords(const std::string& recorded, const std::string& computed);

}  // namespace noonmark
