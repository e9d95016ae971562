#include "app/questions/glazing_question.h"

#include "app/questions/saved_question.h"
#include "app/report/files/element_files.h"
#include "core/base/memory_guard.h"
#include "core/describe/text.h"
#include "core/review/criteria/criterion_days.h"
#include "core/study/glazing/glazing_text.h"
#include "core/study/review_figures.h"
#include "core/study/text/error_text.h"
#include "scenarios/project/results/save_result.h"

namespace noonmark {

namespace {

// Whatever the buildings.
bool asksSame(const GlazingQuestion& a, const GlazingQuestion& b) {
    return isSameRule(a.rule, b.rule) && a.settings.elements == b.settings.elements &&
           a.settings.region == b.settings.region && a.settings.zone == b.settings.zone &&
           a.settings.year == b.settings.year;
}

/// The options of the command line that ask for the same windows and sheets.
std::vector<CommandOption> repeatOptions(const GlazingQuestion& question, const BookSettings& sheets) {
    std::vector<CommandOption> options = makeRepeatOptions(question.settings.elements);
    options.insert(options.end(), question.repeat.begin(), question.repeat.end());
    for (CommandOption& option : makeRepeatOptions(sheets)) options.push_back(std::move(option));
    return options;
}

/// The verdicts of a rule on windows.
class GlazingVerdictsAnswer final : public AnswerOf<GlazingAnswer> {
public:
    GlazingVerdictsAnswer(std::shared_ptr<const GlazingAnswer> review,
                          std::shared_ptr<const ReviewSource> source)
        : AnswerOf(std::move(review)), source_(std::move(source)) {}

    [[nodiscard]] const Question& question() const override { return glazingQuestion(); }
    [[nodiscard]] const StudySettings* settings() const override { return nullptr; }
    [[nodiscard]] MeasuredPart part() const override { return {asked().to, asked().from, {}, {}}; }
    [[nodiscard]] const Warnings& warnings() const override { return content().study.warnings; }
    [[nodiscard]] double seconds() const override { return content().study.seconds.at("total"); }
    [[nodiscard]] bool asksSameAs(const Answer& other) const override {
        const auto* review = other.as<GlazingAnswer>();
        return review && Answer::asksSameAs(other) && asksSame(asked(), review->question);
    }

    /// It names its cities itself, whatever is displayed.
    [[nodiscard]] std::shared_ptr<const Answer> updated(const Project&, const std::string&,
                                                        const std::string&) const override {
        return nullptr;
    }
    [[nodiscard]] std::shared_ptr<const Answer> stated(Provenance provenance) const override {
        auto source = std::make_shared<ReviewSource>(*source_);
        source->stated = std::move(provenance);
        return std::make_shared<GlazingVerdictsAnswer>(shared(), std::move(source));
    }

    [[nodiscard]] AnswerPage page(const LegendChoice&) const override {
        const GlazingStudy& study = content().study;
        return makeGlazingPage(study.windowChanges, study.rule.name, asked().from, asked().to);
    }
    [[nodiscard]] std::vector<FigureLine> figures() const override {
        return listLines(glazingVerdictFigures().of(content().study.windowChanges));
    }
    [[nodiscard]] Result<std::string> command() const override {
        return makeRepeatCommand(content().study, makeLabels());
    }
    [[nodiscard]] std::vector<CommandOption> drawnOptions(const AnswerFiles& how) const override {
        return makeRepeatOptions(bookOf(how));
    }
    [[nodiscard]] std::string json() const override {
        return toJsonText(glazingReviewJson(content().study, makeLabels()));
    }
    /// Without its single windows, of which a city has a hundred thousand.
    [[nodiscard]] SavedResult toSave(const Project& project) const override {
        nlohmann::ordered_json json = glazingReviewJson(content().study, makeLabels());
        json.erase("windows");
        json.update(figuresJson(glazingVerdictFigures().of(content().study.windowChanges)));
        json["engine_settings"] = content().study.engine;
        json["region"] = asked().settings.region.name;
        return makeSavedResult(project, std::string(question().key), asked().to, asked().from,
                               std::move(json));
    }
    [[nodiscard]] std::vector<std::string> fileNames(const AnswerFiles&) const override {
        return glazingFileNames();
    }
    [[nodiscard]] Result<std::vector<std::filesystem::path>> write(const City&,
                                                                   const std::filesystem::path& folder,
                                                                   const AnswerFiles& how) const override {
        GlazingStudy study = content().study;
        study.warnings = statedWarnings(std::move(study.warnings), *source_);
        const BookSettings sheets = bookOf(how);
        const ReviewLabels labels = makeLabels(sheets);
        NoProgress quiet;
        return writeGlazingFiles(
            {study, labels, *asked().before, *asked().after, source_->project.reading->heights}, sheets,
            folder, how.byteOrderMark, how.rules, how.progress ? *how.progress : quiet, how.stop);
    }

private:
    [[nodiscard]] const GlazingQuestion& asked() const { return content().question; }
    [[nodiscard]] ReviewLabels makeLabels(const BookSettings& sheets = {}) const {
        return {
            asked().from, asked().to, provenanceOf(*source_, asked()), {}, repeatOptions(asked(), sheets)};
    }

    std::shared_ptr<const ReviewSource> source_;
};

Result<std::shared_ptr<const Answer>> computeGlazing(const Asked& asked, Progress& progress,
                                                     const std::stop_token& stop) {
    return computeGlazingReview(*asked.glazing, progress, stop)
        .map([&](GlazingAnswer review) -> std::shared_ptr<const Answer> {
            return std::make_shared<GlazingVerdictsAnswer>(
                std::make_shared<const GlazingAnswer>(std::move(review)), asked.reviewSource);
        });
}

AnswerPage pageOfSavedGlazing(const SavedContent& saved, const LegendChoice&) {
    const auto json = nlohmann::ordered_json::parse(saved.result->settings);
    const auto countOf = [&](const char* key) { return json.at(key).get<std::size_t>(); };
    VerdictChanges changes;
    changes.after = {countOf("windows_passing"), countOf("windows_borderline"), countOf("windows_failing")};
    changes.worse = countOf("windows_worse");
    changes.better = countOf("windows_better");
    return makeGlazingPage(changes, json.at("rule_name"), saved.result->baseline, saved.result->scenario);
}

}  // namespace

const Question& glazingQuestion() {
    static const Question question{.key = "glazing-review",
                                   .label = NM_TEXT("Review of windows"),
                                   .ofRun = false,
                                   .ofBaseline = false,
                                   .compute = computeGlazing,
                                   .saved = SavedForm{.page = pageOfSavedGlazing},
                                   .figures = glazingVerdictFigures().rows(),
                                   .filed = FiledForm{"review", "review.json", "sheets.pdf", true}};
    return question;
}

std::shared_ptr<const Answer> makeAnswer(std::shared_ptr<const GlazingAnswer> review,
                                         std::shared_ptr<const ReviewSource> source) {
    return std::make_shared<GlazingVerdictsAnswer>(std::move(review), std::move(source));
}

bool isSame(const GlazingQuestion& a, const GlazingQuestion& b) {
    return isOfSameCase(a, b) && asksSame(a, b);
}

Result<GlazingAnswer> computeGlazingReview(const GlazingQuestion& given, Progress& progress,
                                           const std::stop_token& stop, const AnnounceGlazing& announce) {
    GlazingQuestion question = given;
    if (question.to == question.from) question.rule = dropComparisons(std::move(question.rule));
    std::optional<InputFile> file;
    if (question.settings.elements.places == ElementPlaces::windows) {
        auto described = describeInputFile(question.settings.elements.windows);
        if (!described) return tl::make_unexpected(described.error());
        file = *std::move(described);
    }
    return guardMemory({.what = "a review"},
                       [&] {
                           return runGlazingReview(question.rule, *question.before, *question.after,
                                                   question.settings, progress, stop, announce);
                       })
        .map([&](GlazingStudy study) {
            study.glazingInput = std::move(file);
            return GlazingAnswer{question, std::move(study)};
        });
}

}  // namespace noonmark
