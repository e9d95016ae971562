#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace noonmark {

/// A language in which people read texts and numbers. Core writes English with a decimal point, which files
/// for machines keep; what only people read asks localText() and localNumbers(), and is in the language of
/// the WordingScope around it. Thread-safe.
class Wording {
public:
    Wording() = default;
    Wording(const Wording&) = delete;
    Wording& operator=(const Wording&) = delete;
    virtual ~Wording() = default;

    /// A text that is marked by NM_TEXT; one that has no translation as it is.
    [[nodiscard]] virtual std::string text(std::string_view english) const = 0;
    /// A text of a rule file, which is not to meet other texts of the program: a rule may be called "Tower".
    [[nodiscard]] virtual std::string ruleText(std::string_view english) const = 0;
    /// The numbers of a text of core, "1,204.5 m² (0.25 %)", as the language writes them.
    [[nodiscard]] virtual std::string numbers(std::string_view english) const = 0;
    /// "21 Dec 2026". The day must be ok().
    [[nodiscard]] virtual std::string date(std::chrono::year_month_day day) const = 0;
    /// "December" or, short, "Dec".
    [[nodiscard]] virtual std::string month(std::chrono::month month, bool isShort) const = 0;
    [[nodiscard]] virtual std::string code() const = 0;  ///< BCP 47: "de"
};

/// English as core writes it.
const Wording& englishWording();

/// The language of the scope around the call in this thread; English without one.
const Wording& wordingInUse();

/// The language of the scope around the call; null without one.
const Wording* findScopedWording();

/// What this thread writes for people is in that language while it lives.
class WordingScope {
public:
    explicit WordingScope(const Wording& wording);
    WordingScope(const WordingScope&) = delete;
    WordingScope& operator=(const WordingScope&) = delete;
    ~WordingScope();

private:
    const Wording* before_;
};

/// What is written for machines, also where people's texts surround it: the record in a PDF.
template <class Make>
auto inEnglish(const Make& make) {
    const WordingScope english(englishWording());
    return make();
}

inline bool isEnglishInUse() { return &wordingInUse() == &englishWording(); }
inline std::string localText(std::string_view english) { return wordingInUse().text(english); }
inline std::string localRuleText(std::string_view english) { return wordingInUse().ruleText(english); }
inline std::string localNumbers(std::string_view english) { return wordingInUse().numbers(english); }

}  // namespace noonmark
