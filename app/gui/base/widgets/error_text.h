#pragma once

#include <QString>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/language/translated_text.h"
#include "core/base/result.h"
#include "core/base/warnings.h"

namespace noonmark {

/// translated() as a sentence of its own: with a capital, and the sign of multiplication for an x.
inline QString translatedSentence(std::string_view text) {
    QString sentence = translated(text);
    if (!sentence.isEmpty()) sentence[0] = sentence[0].toUpper();
    return sentence.replace(QStringLiteral(" x "), QStringLiteral(" × "));
}

/// Errors of the window itself are marked where they are made: QT_TRANSLATE_NOOP("Error", ...).
Error noCityError();

/// What is wrong, where, and what to do: Error::text(), in the language of the window where its texts are
/// marked. Others are English, as are all that hold a number or a name.
QString describeError(const Error& error);

/// "28 repaired: outline crossed itself", in the language of the window as far as describeError() is.
QString describeWarning(const WarningGroup& group);
/// The same with at most so many places: "28 repaired: outline crossed itself (way 3, way 7, way 9, ...)".
QString describeWarningWithPlaces(const WarningGroup& group, std::size_t maximum = 3);

/// Why scenarios could not be computed, by name.
using ScenarioErrors = std::vector<std::pair<std::string, Error>>;

/// One error about all of them, of which there is at least one: if they have the same, that one, with their
/// names unless all `asked` have it. The panel Scenarios states each one's.
Error sumUp(const ScenarioErrors& errors, std::size_t asked);

}  // namespace noonmark
