#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace noonmark {

/// What a word in the name of a field or a layer is about, in the languages of the world's open data.
enum class NameWord {
    height,
    storey,
    count,     ///< "number of"
    building,  ///< the building itself
    roof,
    eaves,
    ground,
    terrainModel,  ///< the bare ground, as an elevation: DTM
    elevation,     ///< above sea level or another datum
    above,         ///< above the ground
    below,         ///< below the ground
    typical,       ///< mean or median
    greatest,
    minimum,
    feet,
    usSurveyFeet,
    metres,
    centimetres,
    decimetres,
    millimetres,
    inches,
    filler,      ///< "of", "in"
    otherThing,  ///< a measure, code or note that is neither a height nor storeys
    otherLayer,  ///< what layers beside those of buildings hold: plots, streets, districts
};

/// A name in lower case without accents, blanks and punctuation, for comparisons: "Höhe (m)" is "hohem",
/// "建物高さ" stays as it is. UTF-8; bytes that are not are dropped.
std::string foldName(std::string_view name);

/// The words of a name, folded; they end at blanks, punctuation and digits and before a capital:
/// "HeightInFeet" is height, in, feet. Words written together are told apart where all of them are known.
std::vector<std::string> wordsOfName(std::string_view name);

/// Nothing for an unknown word. `word`: one of wordsOfName().
std::optional<NameWord> findNameWord(std::string_view word);

/// The known words of a name.
class NameWords {
public:
    explicit NameWords(std::string_view name);
    [[nodiscard]] bool has(NameWord word) const;
    /// It ends in "in": inches, or a name that was cut off before its unit.
    [[nodiscard]] bool endsInIn() const { return endsInIn_; }
    [[nodiscard]] bool areAllKnown() const { return unknown_ == 0; }

private:
    std::vector<NameWord> known_;
    std::size_t unknown_ = 0;
    bool endsInIn_ = false;
};

}  // namespace noonmark
