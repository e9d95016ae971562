#pragma once

#include <QCoreApplication>
#include <QString>
#include <string>
#include <string_view>

namespace noonmark {

/// A text that core marks by NM_TEXT, in the user's language. lupdate takes the lists of core that are a
/// std::array, and functions that return a std::string_view, for parts of `std`.
inline QString translated(std::string_view text) {
    const std::string source(text);
    const QString found = QCoreApplication::translate("noonmark", source.c_str());
    return found == QString::fromStdString(source) ? QCoreApplication::translate("std", source.c_str())
                                                   : found;
}

/// The same as a sentence of its own: with a capital, and the sign of multiplication for an x.
inline QString translatedSentence(std::string_view text) {
    QString sentence = translated(text);
    if (!sentence.isEmpty()) sentence[0] = sentence[0].toUpper();
    return sentence.replace(QStringLiteral(" x "), QStringLiteral(" × "));
}

}  // namespace noonmark
