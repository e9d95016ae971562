#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/units.h"
#include "core/describe/figure.h"

namespace noonmark {

/// A number as people read it.
struct Amount {
    double value = 0;  ///< as FigureUnit says that it is held; NaN: not counted
    FigureUnit unit = FigureUnit::none;
    int decimals = 1;  ///< at most; areas have none
    bool isChange = false;
};

/// "4.3 h", "+1,204 m²", "not counted".
std::string valueOf(const Amount& amount, UnitSystem units = UnitSystem::metric);

/// A sentence about a result, which the GUI shows in the user's language.
struct Sentence {
    using Argument = std::variant<std::string, Amount>;  ///< a name of the user's, or a number

    std::string_view source = {};  ///< NM_TEXT: "%1" to "%9" stand for the arguments. Empty: no sentence
    std::vector<Argument> arguments{};
};

/// The sentence in English, with a capital at its beginning.
std::string formatText(const Sentence& sentence, UnitSystem units = UnitSystem::metric);

/// Replaces "%1" by the first value and so on, each where it stands in `text`; values are not searched.
std::string fillIn(std::string_view text, std::span<const std::string> values);

}  // namespace noonmark
