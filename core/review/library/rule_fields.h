#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/review/rule/rule_names.h"

namespace noonmark {

using RuleJson = nlohmann::ordered_json;

/// At most 60 of a to z, 0 to 9 and hyphens.
bool isRuleKey(const std::string& key);

/// Whether a text has no control characters and at most 2,000 bytes.
bool isPlainText(const std::string& text);

/// The first thing that is wrong in a rule file. What follows is read with defaults and thrown away.
struct RuleProblem {
    std::string file;
    std::optional<Error> error;
    /// Records the error of the field at `path` unless there is one already.
    void add(const std::string& path, std::string what, std::string advice = {});
};

/// Reads the fields of one JSON object and checks that there are no others. A field that is missing or wrong
/// is added to `problem`, and a default is returned. "comment" is allowed everywhere.
class RuleFields {
public:
    RuleFields(const RuleJson& json, std::string path, RuleProblem& problem);

    [[nodiscard]] bool has(const char* key) const;
    /// Not empty, at most 2,000 bytes, without control characters.
    std::string text(const char* key);
    std::string textOr(const char* key, std::string otherwise);
    double number(const char* key, double lowest, double highest);
    double numberOr(const char* key, double lowest, double highest, double otherwise);
    int wholeOr(const char* key, int lowest, int highest, int otherwise);
    bool flagOr(const char* key, bool otherwise);
    [[nodiscard]] bool isFlag(const char* key) const;    ///< whether it is true or false
    [[nodiscard]] bool isObject(const char* key) const;  ///< whether it has fields of its own
    std::vector<std::string> texts(const char* key);     ///< empty if there is no such field
    /// The object of that name; an empty object, and a problem, if it is missing.
    RuleFields object(const char* key);
    /// The elements of an array of at most 400; empty if there is no such field.
    std::vector<RuleJson> elements(const char* key);
    /// Keys and values of an object of at most 400; empty if there is no such field.
    std::vector<std::pair<std::string, RuleJson>> members(const char* key);

    template <class E>
    E name(const char* key, RuleNames<E> names) {
        const std::string wanted = text(key);
        std::vector<std::string_view> known;
        for (const auto& [value, candidate] : names) {
            if (candidate == wanted) return value;
            known.push_back(candidate);
        }
        if (!wanted.empty())
            addProblem(key, fmt::format("'{}' is not known", wanted),
                       fmt::format("Give one of: {}", fmt::join(known, ", ")));
        return names.front().first;
    }
    template <class E>
    E nameOr(const char* key, RuleNames<E> names, E otherwise) {
        return has(key) ? name(key, names) : otherwise;
    }

    void addProblem(const char* key, std::string what, std::string advice = {});
    RuleProblem& problem() { return *problem_; }
    [[nodiscard]] std::string pathOf(const std::string& key) const;
    /// Adds a problem if there is a field that none of these calls read.
    void finish();

private:
    const RuleJson* find(const char* key);

    RuleJson json_;
    std::string path_;
    RuleProblem* problem_;
    std::set<std::string> known_;
};

// The parts of a rule; each reads the field of its name (docs/rules.md).

RuleDays readDays(RuleFields& rule, const std::string& ruleSource);
CountedHours readRuleHours(RuleFields& rule, const std::string& ruleSource);
RuleClock readClock(RuleFields& rule, const std::string& ruleSource);
RuleSampling readSampling(RuleFields& rule, const std::string& ruleSource);
RuleReceivers readReceivers(RuleFields& rule, const std::string& ruleSource);
RuleOccluders readOccluders(RuleFields& rule, const std::string& ruleSource);
RuleBaseline readBaseline(RuleFields& rule, const std::string& ruleSource);
Deliverables readDeliverables(RuleFields& rule, const std::string& ruleSource);

/// Status and source of a part of a rule; the source of the rule where the part states none.
Evidence readEvidence(RuleFields& fields, const std::string& ruleSource);

/// The field `criteria` of a rule.
std::vector<Criterion> readCriteria(RuleFields& rule, const std::string& ruleSource);

/// The fields of `receivers` that are about windows: point, opening, sweep and unit.
RuleGlazing readRuleGlazing(RuleFields& receivers, const std::string& ruleSource);

/// The fields `holds_if`, `shares` and `sunshine` of a rule whose criteria have been read; a problem where
/// they, or criteria about windows, are in a rule about places.
void readGlazingVerdicts(RuleFields& fields, Rule& rule);

}  // namespace noonmark
