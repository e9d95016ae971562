#include "app/language/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QSettings>
#include <QTranslator>
#include <algorithm>
#include <atomic>
#include <clocale>

namespace noonmark {

namespace {

const QString languageKey = QStringLiteral("language");
const QString translatorName = QStringLiteral("noonmarkTranslator");

// What Qt writes on buttons and in menus, for systems without Qt's own translations.
[[maybe_unused]] constexpr const char* wordsOfQt[] = {
    QT_TRANSLATE_NOOP("QPlatformTheme", "OK"),    QT_TRANSLATE_NOOP("QPlatformTheme", "Save"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Open"),  QT_TRANSLATE_NOOP("QPlatformTheme", "&Yes"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "&No"),   QT_TRANSLATE_NOOP("QPlatformTheme", "Cancel"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Close"), QT_TRANSLATE_NOOP("QPlatformTheme", "Discard"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Apply"), QT_TRANSLATE_NOOP("QPlatformTheme", "Reset"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Help"),  QT_TRANSLATE_NOOP("QPlatformTheme", "Retry"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Abort"), QT_TRANSLATE_NOOP("QPlatformTheme", "Ignore"),
    QT_TRANSLATE_NOOP("QUndoStack", "Undo %1"),   QT_TRANSLATE_NOOP("QUndoStack", "Redo %1"),
    QT_TRANSLATE_NOOP("QUndoStack", "Undo"),      QT_TRANSLATE_NOOP("QUndoStack", "Redo")};

const LanguageEntry& entryOf(Language language) {
    return *std::find_if(languages.begin(), languages.end(),
                         [&](const LanguageEntry& entry) { return entry.language == language; });
}

bool isShipped(const QString& code) {
    return !code.isEmpty() &&
           std::any_of(languages.begin(), languages.end(),
                       [&](const LanguageEntry& entry) { return code == QLatin1String(entry.code); });
}

void install(const QString& file, const QString& folder, QCoreApplication& application) {
    auto* translator = new QTranslator(&application);
    translator->setObjectName(translatorName);
    if (translator->load(file, folder)) QCoreApplication::installTranslator(translator);
}

}  // namespace

namespace {

std::atomic<int> changes = 0;
std::atomic<Language> languageOfWindow = Language::english;

}  // namespace

Language languageInUse() { return languageOfWindow; }

int countLanguageChanges() { return changes; }

void noteLanguageChange() { ++changes; }

Language readLanguage(const QSettings& settings) {
    const QString code = settings.value(languageKey).toString();
    for (const LanguageEntry& entry : languages)
        if (code == QLatin1String(entry.code)) return entry.language;
    return Language::system;
}

void saveLanguage(Language language, QSettings& settings) {
    settings.setValue(languageKey, QString::fromLatin1(entryOf(language).code));
}

QString findTranslation(Language language, const QStringList& preferred) {
    if (language != Language::system) return QString::fromLatin1(entryOf(language).code);
    for (const QString& name : preferred) {
        const QString code = name.section(QLatin1Char('-'), 0, 0);
        if (isShipped(code)) return code;
    }
    return QStringLiteral("en");
}

QLocale chooseLocale(const QString& code, const QLocale& system) {
    const bool speaksIt = system.name().section(QLatin1Char('_'), 0, 0) == code;
    return speaksIt ? system : QLocale(code);
}

void applyLanguage(Language language, QCoreApplication& application) {
    qDeleteAll(application.findChildren<QTranslator*>(translatorName));
    noteLanguageChange();
    const QString code = findTranslation(language, QLocale::system().uiLanguages());
    for (const LanguageEntry& entry : languages)
        if (code == QLatin1String(entry.code)) languageOfWindow = entry.language;
    // Qt took the decimal comma of the system for C functions too, which read and write files.
    std::setlocale(LC_NUMERIC, "C");
    QLocale::setDefault(chooseLocale(code, QLocale::system()));
    // English holds the plural forms only, which another language's unfinished texts fall back to.
    install(QStringLiteral("noonmark_en"), QStringLiteral(":/translations"), application);
    if (code == QStringLiteral("en")) return;
    install(QStringLiteral("qtbase_") + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath),
            application);
    install(QStringLiteral("noonmark_") + code, QStringLiteral(":/translations"), application);
}

}  // namespace noonmark
