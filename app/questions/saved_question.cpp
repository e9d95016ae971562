#include "app/questions/saved_question.h"

#include <nlohmann/json.hpp>

#include "app/questions/question.h"
#include "app/report/files/saved_files.h"
#include "app/report/sheets/impact_report.h"
#include "core/describe/text.h"
#include "core/measures/shadow_figures.h"
#include "core/study/text/region_text.h"
#include "scenarios/weights/score_figures.h"

namespace noonmark {

namespace {

std::vector<std::string> listChanges(const SavedContent& saved) {
    std::vector<std::string> all = saved.changes;
    all.insert(all.end(), saved.weightChanges.begin(), saved.weightChanges.end());
    return all;
}

AnswerPage pageOf(const SavedStudy& study, const SavedContent& saved, ShownAs show) {
    Region region;
    region.name = saved.answer.origin.region;
    return withMonths(makePage(study.field, study.statistics, nameOf(region), show),
                      makeMonthBars(study.months, study.start, study.field.days));
}

AnswerPage pageOf(const SavedImpact& impact, const SavedContent&, ShownAs show) {
    return makePage(impact.impact, impact.figures, show);
}

AnswerPage pageOf(const SavedScore& score, const SavedContent& saved, ShownAs show) {
    return makePage(score.score, saved.result->scenario, show);
}

AnswerPage pageOf(const SavedElements& points, const SavedContent&, ShownAs) {
    return makePage(points.map, points.figures);
}

AnswerPage pageOf(const SavedSunByPlace& places, const SavedContent&, ShownAs) {
    return makePage(places.sun);
}

// The options that draw the same.
std::vector<CommandOption> drawnOf(const SavedStudy&, const AnswerFiles& how) {
    return listLegendOptions(how.legend, false);
}
std::vector<CommandOption> drawnOf(const SavedImpact&, const AnswerFiles& how) {
    return drawnOptions(how.scale, how.legend);
}
std::vector<CommandOption> drawnOf(const SavedScore&, const AnswerFiles& how) {
    return listLegendOptions(how.legend, true);
}
std::vector<CommandOption> drawnOf(const SavedElements&, const AnswerFiles&) { return {}; }
std::vector<CommandOption> drawnOf(const SavedSunByPlace&, const AnswerFiles&) { return {}; }

// Its JSON states it, or why there is none (addRepeat() in provenance_json.h).
Result<std::string> commandOf(const SavedResult& result) {
    const auto json = nlohmann::ordered_json::parse(result.settings, nullptr, false);
    const auto textOf = [&](const char* key) {
        return json.is_object() && json.contains(key) && json[key].is_string() ? json[key].get<std::string>()
                                                                               : std::string();
    };
    if (std::string command = textOf("repeat"); !command.empty()) return command;
    std::string why = textOf("repeat_note");
    return failure(why.empty() ? "The saved result states no command" : std::move(why), result.name,
                   "Ask the question again");
}

/// A result of any kind as it was saved in the project.
class SavedResultAnswer final : public AnswerOf<SavedContent> {
public:
    using AnswerOf::AnswerOf;

    [[nodiscard]] const Question& question() const override { return savedQuestion(); }
    [[nodiscard]] const StudySettings* settings() const override { return nullptr; }
    [[nodiscard]] MeasuredPart part() const override {
        return {content().result->scenario, content().result->baseline, {}, content().answer.origin.weights};
    }
    [[nodiscard]] const Warnings& warnings() const override {
        static const Warnings none;
        return none;
    }
    [[nodiscard]] double seconds() const override { return 0; }

    [[nodiscard]] std::shared_ptr<const Answer> updated(const Project& project, const std::string&,
                                                        const std::string&) const override {
        auto changes = findWeightChangesSince(content().answer.origin, project);
        if (changes == content().weightChanges) return nullptr;
        auto now = std::make_shared<SavedContent>(content());
        now->weightChanges = std::move(changes);
        return std::make_shared<SavedResultAnswer>(std::move(now));
    }
    [[nodiscard]] std::shared_ptr<const Answer> stated(Provenance) const override {
        return std::make_shared<SavedResultAnswer>(shared());
    }

    [[nodiscard]] AnswerPage page(ShownAs show) const override {
        return std::visit([&](const auto& saved) { return pageOf(saved, content(), show); },
                          content().answer.answer);
    }
    [[nodiscard]] Result<std::string> command() const override { return commandOf(*content().result); }

    [[nodiscard]] std::vector<CommandOption> drawnOptions(const AnswerFiles& how) const override {
        return std::visit([&](const auto& saved) { return drawnOf(saved, how); }, content().answer.answer);
    }
    [[nodiscard]] std::string json() const override { return content().result->settings; }
    [[nodiscard]] SavedResult toSave(const Project&) const override { return *content().result; }
    [[nodiscard]] std::vector<std::string> fileNames(const AnswerFiles&) const override {
        return savedFileNames(*content().result);
    }
    [[nodiscard]] Result<std::vector<std::filesystem::path>> write(const City& city,
                                                                   const std::filesystem::path& folder,
                                                                   const AnswerFiles& how) const override {
        return writeSavedFiles(*content().result, {city, listChanges(content()), how.regions}, how.scale,
                               folder, how.rules, how.pictureWidth, how.legend);
    }
};

}  // namespace

const Question& savedQuestion() {
    static const Question question{.key = "saved", .label = NM_TEXT("Saved result"), .ofRun = false};
    return question;
}

Result<std::shared_ptr<const Answer>> readSaved(const std::shared_ptr<const SavedResult>& result,
                                                const Project& project) {
    return readSavedAnswer(*result).map([&](SavedAnswer answer) -> std::shared_ptr<const Answer> {
        auto changes = findChangesSince(*result, answer.origin, project);
        auto weightChanges = findWeightChangesSince(answer.origin, project);
        return std::make_shared<SavedResultAnswer>(std::make_shared<const SavedContent>(
            SavedContent{result, std::move(answer), std::move(changes), std::move(weightChanges)}));
    });
}

}  // namespace noonmark
