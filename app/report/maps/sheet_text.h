#pragma once

#include <QString>
#include <string>
#include <string_view>

#include "app/language/translated_text.h"
#include "core/base/wording.h"
#include "core/describe/text.h"

namespace noonmark {

/// The language of a sheet while it is made or painted: the one that is asked for, else that of the scope
/// around, else the window's.
class SheetScope {
public:
    explicit SheetScope(Language language = Language::system)
        : scope_(language == Language::system && findScopedWording() ? *findScopedWording()
                                                                     : wordingOf(language)) {}

private:
    WordingScope scope_;
};

/// A text of sheets, charts and legends, in the language of the SheetScope around the call; English
/// without one. lupdate reads the argument as it reads NM_TEXT.
inline QString sheetText(std::string_view english) { return QString::fromStdString(localText(english)); }
/// The same of a text that a legend or a table holds in English.
inline QString sheetWord(const QString& english) { return sheetText(english.toStdString()); }
/// A text of a rule file.
inline QString sheetRuleText(std::string_view english) {
    return QString::fromStdString(localRuleText(english));
}
/// The numbers of a text without words.
inline QString sheetNumbers(const std::string& text) { return QString::fromStdString(localNumbers(text)); }
/// A number with so many decimals, without separators between thousands.
inline QString fixedNumber(double value, int decimals) {
    return sheetNumbers(QString::number(value, 'f', decimals).toStdString());
}
/// The same with at most so many digits.
inline QString shortNumber(double value, int digits) {
    return sheetNumbers(QString::number(value, 'g', digits).toStdString());
}

}  // namespace noonmark
