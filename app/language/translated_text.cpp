#include "app/language/translated_text.h"

#include <QCoreApplication>
#include <QDate>
#include <QRegularExpression>
#include <QTranslator>
#include <functional>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <utility>

#include "generated/translation_contexts.h"

namespace noonmark {

namespace {

constexpr const char* ruleContext = "Rule";

/// A source text in a context; itself without a translation.
using FindText = std::function<QString(const char* context, const char* source)>;

QString findInContexts(const std::string& source, const FindText& find) {
    const QString english = QString::fromStdString(source);
    for (const char* context : translationContexts)
        if (QString found = find(context, source.c_str()); found != english) return found;
    return english;
}

/// A text is looked for in all contexts, and one that is its own translation in vain: tables ask for the same
/// names at each comparison of two rows.
class KnownTexts {
public:
    QString find(std::string_view text, const FindText& find) {
        if (text.empty()) return {};
        std::string source(text);
        const std::scoped_lock lock(mutex_);
        const bool isOtherLanguage =
            std::exchange(languageChanges_, countLanguageChanges()) != countLanguageChanges();
        if (isOtherLanguage || texts_.size() >= maxTexts) texts_.clear();
        if (const auto found = texts_.find(source); found != texts_.end()) return found->second;
        QString found = findInContexts(source, find);
        return texts_.emplace(std::move(source), std::move(found)).first->second;
    }

private:
    static constexpr std::size_t maxTexts = 100'000;
    std::mutex mutex_;
    std::unordered_map<std::string, QString> texts_;
    int languageChanges_ = 0;
};

/// Texts, numbers and dates by Qt.
class QtWording final : public Wording {
public:
    QtWording(FindText find, std::function<QLocale()> locale)
        : find_(std::move(find)), locale_(std::move(locale)) {}

    [[nodiscard]] std::string text(std::string_view english) const override {
        return known_.find(english, find_).toStdString();
    }
    [[nodiscard]] std::string ruleText(std::string_view english) const override {
        return english.empty() ? std::string()
                               : find_(ruleContext, std::string(english).c_str()).toStdString();
    }
    [[nodiscard]] std::string numbers(std::string_view english) const override {
        return localiseNumbers(QString::fromUtf8(english.data(), qsizetype(english.size())), locale_())
            .toStdString();
    }
    [[nodiscard]] std::string date(std::chrono::year_month_day day) const override {
        const QDate date(int(day.year()), int(unsigned(day.month())), int(unsigned(day.day())));
        return locale_().toString(date, find_("QObject", "d MMM yyyy")).toStdString();
    }
    [[nodiscard]] std::string month(std::chrono::month month, bool isShort) const override {
        return locale_()
            .standaloneMonthName(int(unsigned(month)), isShort ? QLocale::ShortFormat : QLocale::LongFormat)
            .toStdString();
    }
    [[nodiscard]] std::string code() const override { return locale_().bcp47Name().toStdString(); }

private:
    FindText find_;
    std::function<QLocale()> locale_;
    mutable KnownTexts known_;
};

QString findInstalled(const char* context, const char* source) {
    return QCoreApplication::translate(context, source);
}

/// By a translator of its own, which is not installed.
std::unique_ptr<Wording> loadWording(const QString& code) {
    auto translator = std::make_shared<QTranslator>();
    if (!translator->load(QStringLiteral("noonmark_") + code, QStringLiteral(":/translations")))
        return nullptr;
    return std::make_unique<QtWording>(
        [translator](const char* context, const char* source) {
            const QString found = translator->translate(context, source);
            return found.isEmpty() ? QString::fromUtf8(source) : found;
        },
        [code] { return chooseLocale(code, QLocale::system()); });
}

}  // namespace

QString translated(std::string_view text) {
    static KnownTexts known;
    return known.find(text, findInstalled);
}

const Wording& windowWording() {
    static const QtWording window(findInstalled, [] { return QLocale(); });
    return languageInUse() == Language::english ? englishWording() : window;
}

const Wording& wordingOf(Language language) {
    if (language == Language::system) return windowWording();
    if (language == Language::english) return englishWording();
    static std::mutex mutex;
    static std::unordered_map<int, std::unique_ptr<Wording>> loaded;
    const std::scoped_lock lock(mutex);
    const auto [found, isNew] = loaded.try_emplace(int(language));
    if (isNew) found->second = loadWording(findTranslation(language, {}));
    return found->second ? *found->second : englishWording();
}

QString localiseNumbers(const QString& text, const QLocale& locale) {
    static const QRegularExpression number(
        QStringLiteral("(?<![\\w.,])(\\d{1,3}(?:,\\d{3})+|\\d+)(\\.\\d+)?(?![\\w.]*\\d)"));
    QString local;
    qsizetype at = 0;
    for (auto found = number.globalMatch(text); found.hasNext();) {
        const QRegularExpressionMatch match = found.next();
        const QString point = match.captured(2).isEmpty() ? QString() : locale.decimalPoint();
        local += text.mid(at, match.capturedStart() - at);
        local += match.captured(1).replace(QLatin1Char(','), locale.groupSeparator()) + point +
                 match.captured(2).mid(1);
        at = match.capturedEnd();
    }
    return local + text.mid(at);
}

}  // namespace noonmark
