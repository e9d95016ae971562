#pragma once

// The language of the window: which translation it shows and how it writes numbers and dates, and that of
// sheets. Files that programs read and most errors of core are English in every language.

#include <QLocale>
#include <QString>
#include <array>

class QCoreApplication;
class QSettings;

namespace noonmark {

enum class Language { system, english, german, spanish, japanese };

struct LanguageEntry {
    Language language;
    const char* code;     ///< ISO 639-1, in settings and names of files; empty: the system's
    const char* ownName;  ///< as its speakers write it, UTF-8; null: the system's
};

inline constexpr std::array languages{
    LanguageEntry{Language::system, "", nullptr}, LanguageEntry{Language::english, "en", "English"},
    LanguageEntry{Language::german, "de", "Deutsch"}, LanguageEntry{Language::spanish, "es", "Español"},
    LanguageEntry{Language::japanese, "ja", "日本語"}};

/// The language saved in the settings; the system's at first, and for a code that is not in the list.
Language readLanguage(const QSettings& settings);
void saveLanguage(Language language, QSettings& settings);

/// The code of a translation: that of `language`, for the system's the first of `preferred` (as
/// QLocale::uiLanguages()) that there is, else "en".
QString findTranslation(Language language, const QStringList& preferred);
/// Numbers and dates: the system's where it has that language ("de-AT"), else those of the language.
QLocale chooseLocale(const QString& code, const QLocale& system);

/// Installs the translations of Noonmark and, where Qt's are installed, of Qt's own dialogs, and makes the
/// locale the default. Before any widget: texts already shown do not change. Translators that an earlier call
/// installed are removed.
void applyLanguage(Language language, QCoreApplication& application);

/// The language that applyLanguage() chose, never Language::system; English before.
Language languageInUse();

/// How often the language has changed: what was translated under another count is found anew. Whoever
/// installs a translator by hand notes it.
int countLanguageChanges();
void noteLanguageChange();

}  // namespace noonmark
