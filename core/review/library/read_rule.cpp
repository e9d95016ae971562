#include "core/review/library/read_rule.h"

#include <fstream>
#include <set>

#include "core/review/library/rule_fields.h"
#include "core/review/places/review_columns.h"

namespace noonmark {

namespace {

constexpr std::size_t largestRuleFile = std::size_t{256} * 1024;
constexpr int deepestRule = 12;

/// Notes what nlohmann's parser accepts and a rule may not have.
struct RuleShape {
    std::vector<std::set<std::string>> keys;
    bool tooDeep = false;
    std::string twice;

    bool see(int depth, RuleJson::parse_event_t event, const RuleJson& parsed) {
        using Event = RuleJson::parse_event_t;
        if (depth > deepestRule) tooDeep = true;
        if (tooDeep) return false;
        if (event == Event::object_start) keys.emplace_back();
        if (event == Event::object_end && !keys.empty()) keys.pop_back();
        if (event == Event::key && !keys.empty() && !keys.back().insert(parsed.get<std::string>()).second)
            if (twice.empty()) twice = parsed.get<std::string>().substr(0, 60);
        return true;
    }
};

Result<RuleJson> parseJson(std::string_view text, const std::string& file) {
    if (text.size() > largestRuleFile)
        return failure("The rule file is larger than 256 kB", file, "Rules are a few kilobytes");
    RuleShape shape;
    RuleJson json = RuleJson::parse(
        text,
        [&](int depth, RuleJson::parse_event_t event, RuleJson& parsed) {
            return shape.see(depth, event, parsed);
        },
        false);
    if (shape.tooDeep)
        return failure(fmt::format("The rule is nested more than {} deep", deepestRule), file,
                       "See docs/rules.md");
    if (json.is_discarded())
        return failure("The file is not JSON", file, "Check it with a JSON editor, and that it is UTF-8");
    if (!shape.twice.empty())
        return failure("A field is there twice in one object", file, "Remove one of them");
    if (!json.is_object()) return failure("A rule is one JSON object", file, "See docs/rules.md");
    return json;
}

/// The names of the rule's choices and of their options, checked.
std::map<std::string, std::vector<std::string>> choicesIn(RuleFields& fields) {
    std::map<std::string, std::vector<std::string>> all;
    for (const auto& [choice, json] : fields.members("choices")) {
        const std::string path = isPlainText(choice) ? "choices." + choice : "choices";
        if (!isPlainText(choice))
            fields.problem().add(path, "A choice needs a name without control characters");
        if (!json.is_object() || json.empty())
            fields.problem().add(path, "An object of options is needed here", "See docs/rules.md");
        if (!json.is_object()) continue;
        for (const auto& [option, patch] : json.items()) {
            if (!patch.is_object()) fields.problem().add(path, "An option is an object of fields to change");
            if (!isPlainText(option)) fields.problem().add(path, "An option needs a plain name");
            all[choice].push_back(option);
        }
    }
    return all;
}

Result<void> checkChoices(const std::map<std::string, std::vector<std::string>>& known,
                          const RuleChoices& choices, const std::string& file) {
    for (const auto& [choice, option] : choices) {
        const auto found = known.find(choice);
        if (found == known.end())
            return failure(fmt::format("The rule has no choice '{}'", choice), file,
                           "`review show` lists the choices of a rule");
        if (std::ranges::find(found->second, option) == found->second.end())
            return failure(fmt::format("The choice '{}' has no option '{}'", choice, option), file,
                           fmt::format("Give one of: {}", fmt::join(found->second, ", ")));
    }
    return {};
}

/// Changes the fields that the chosen options name (RFC 7396); returns what was chosen.
RuleChoices applyChoices(RuleJson& json, const std::map<std::string, std::vector<std::string>>& known,
                         const RuleChoices& choices) {
    RuleChoices chosen;
    const RuleJson options = json.value("choices", RuleJson::object());
    for (const auto& [choice, names] : known) {
        const auto wanted = choices.find(choice);
        chosen[choice] = wanted == choices.end() ? names.front() : wanted->second;
        const RuleJson& patch = options.at(choice).at(chosen[choice]);
        if (patch.is_object() && !patch.contains("choices")) json.merge_patch(patch);
    }
    return chosen;
}

std::vector<StatedFigure> readFigures(RuleFields& rule, const std::string& source) {
    std::vector<StatedFigure> figures;
    for (const RuleJson& json : rule.elements("figures")) {
        RuleFields fields(json, fmt::format("figures[{}]", figures.size()), rule.problem());
        figures.push_back({fields.text("text"), readEvidence(fields, source)});
        fields.finish();
    }
    return figures;
}

std::optional<RuleArea> readArea(RuleFields& fields) {
    if (!fields.has("near")) return std::nullopt;
    RuleFields near = fields.object("near");
    const LonLat centre{near.number("lon_deg", -180, 180), near.number("lat_deg", -90, 90)};
    const RuleArea area{centre, 1000 * near.number("km", 1, 2000)};
    near.finish();
    return area;
}

void readHeading(RuleFields& fields, Rule& rule) {
    if (fields.numberOr("schema", 1, 1, 0) != 1) fields.addProblem("schema", "The schema must be 1");
    rule.key = fields.text("key");
    if (!isRuleKey(rule.key))
        fields.addProblem("key", "A key has at most 60 of a to z, 0 to 9 and hyphens", "Write my-own-rule");
    rule.name = fields.text("name");
    rule.where = fields.textOr("where", {});
    rule.countries = fields.texts("countries");
    const auto isCode = [](const std::string& code) {
        return code.size() == 2 && std::ranges::all_of(code, [](char c) { return c >= 'A' && c <= 'Z'; });
    };
    if (!std::ranges::all_of(rule.countries, isCode))
        fields.addProblem("countries", "A country is a code of two capital letters (ISO 3166-1)",
                          "Write [\"US\"]");
    rule.area = readArea(fields);
    const std::string half = fields.textOr("hemisphere", "north");
    rule.isSouthern = half == "south";
    if (!rule.isSouthern && half != "north")
        fields.addProblem("hemisphere", "There is no such half of the earth", "Write north or south");
    rule.summary = fields.text("summary");
    rule.source = fields.text("source");
}

void readParts(RuleFields& fields, Rule& rule) {
    rule.days = readDays(fields, rule.source);
    rule.window = readRuleHours(fields, rule.source);
    rule.clock = readClock(fields, rule.source);
    rule.sampling = readSampling(fields, rule.source);
    rule.receivers = readReceivers(fields, rule.source);
    rule.occluders = readOccluders(fields, rule.source);
    rule.baseline = readBaseline(fields, rule.source);
    rule.criteria = readCriteria(fields, rule.source);
    readGlazingVerdicts(fields, rule);
    if (fields.has("theoretical")) {
        RuleFields sum = fields.object("theoretical");
        rule.theoreticalHours = sum.number("hours", 1, 8784);
        rule.theoreticalEvidence = readEvidence(sum, rule.source);
        sum.finish();
    }
    rule.deliverables = readDeliverables(fields, rule.source);
    rule.figures = readFigures(fields, rule.source);
    rule.readings = fields.texts("readings");
    rule.notChecked = fields.texts("not_checked");
}

void checkRule(RuleFields& fields, const Rule& rule) {
    if (rule.occluders.trees != RuleTrees::without && rule.receivers.surface == RuleSurface::plane)
        fields.addProblem("occluders.trees", "The shade of trees is measured on the ground and at windows",
                          "Write without");
    for (const Criterion& criterion : rule.criteria)
        if (criterion.belt != LineBelt::none && !rule.receivers.hasLines())
            fields.addProblem("criteria", "The criterion '" + criterion.key + "' needs receivers.lines_m");
    for (const RuleColumn& column : rule.deliverables.columns)
        if (!isReviewColumn(rule, column.key))
            fields.addProblem("deliverables.columns", fmt::format("There is no column '{}'", column.key),
                              "docs/rules.md lists the keys");
}

}  // namespace

Result<Rule> parseRule(std::string_view text, const std::string& file, const RuleChoices& choices) {
    auto json = parseJson(text, file);
    if (!json) return tl::make_unexpected(json.error());
    RuleProblem problem{file, {}};
    Rule rule;
    RuleFields unchosen(*json, {}, problem);
    rule.choices = choicesIn(unchosen);
    if (problem.error) return tl::make_unexpected(*problem.error);
    if (const auto good = checkChoices(rule.choices, choices, file); !good)
        return tl::make_unexpected(good.error());
    rule.chosen = applyChoices(*json, rule.choices, choices);
    RuleFields fields(*json, {}, problem);
    fields.members("choices");
    readHeading(fields, rule);
    readParts(fields, rule);
    checkRule(fields, rule);
    fields.finish();
    if (problem.error) return tl::make_unexpected(*problem.error);
    return rule;
}

Result<std::string> readRuleText(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error))
        return failure("This is not a file", file.string(), "Check its name");
    std::ifstream stream(file, std::ios::binary);
    std::string text(largestRuleFile + 1, '\0');
    stream.read(text.data(), std::streamsize(text.size()));
    text.resize(std::size_t(std::max<std::streamsize>(0, stream.gcount())));
    if (text.empty()) return failure("The file cannot be read, or is empty", file.string(), "Check its name");
    if (text.size() > largestRuleFile)
        return failure("The rule file is larger than 256 kB", file.string(), "Rules are a few kilobytes");
    return text;
}

}  // namespace noonmark
