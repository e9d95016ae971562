#pragma once

#include <QString>
#include <string>
#include <string_view>

#include "app/language/language.h"
#include "core/base/wording.h"

namespace noonmark {

/// A text that core marks by NM_TEXT, in the user's language. lupdate puts it into the context of the class
/// around the mark; of several translations that of a free function comes first.
/// What was found is remembered until the language changes (noteLanguageChange()).
QString translated(std::string_view text);

/// The language of the window: what applyLanguage() chose; without a call, English.
const Wording& windowWording();

/// The wording of a language, whatever the window's is; of Language::system that of the window. Without
/// translations in the program it is English.
const Wording& wordingOf(Language language);

/// A text of core with its numbers, "1,204.5", written as a language does. Dates, times and version numbers
/// stay.
QString localiseNumbers(const QString& text, const QLocale& locale);

/// What core writes for people, in the language of the window: inWindowWords([&] { return describe(x); }).
template <class Make>
QString inWindowWords(const Make& make) {
    const WordingScope words(windowWording());
    return QString::fromStdString(std::string(make()));
}

}  // namespace noonmark
