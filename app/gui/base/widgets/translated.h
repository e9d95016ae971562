#pragma once

#include <QCoreApplication>
#include <QString>
#include <string>
#include <string_view>

namespace noonmark {

/// A text that core marks by NM_TEXT, in the user's language.
inline QString translated(std::string_view text) {
    return QCoreApplication::translate("noonmark", std::string(text).c_str());
}

/// The same as a sentence of its own: with a capital, and the sign of multiplication for an x.
inline QString translatedSentence(std::string_view text) {
    QString sentence = translated(text);
    if (!sentence.isEmpty()) sentence[0] = sentence[0].toUpper();
    return sentence.replace(QStringLiteral(" x "), QStringLiteral(" × "));
}

}  // namespace noonmark
