#include "app/input/all_engines.h"
#include "app/questions/saved_question.h"
#include "app/report/book/answer_book.h"
#include "app/report/files/answer_files.h"
#include "app/report/sheets/impact_report.h"
#include "core/base/stopwatch.h"
#include "core/describe/text.h"
#include "core/study/review_study.h"
#include "core/study/text/region_text.h"
#include "scenarios/project/results/save_result.h"

namespace noonmark {

namespace {

std::vector<CommandOption> drawnOfComparison(const AnswerFiles& how) {
    return drawnOptions(how.scale, how.legend);
}

/// How shadow changes from one scenario to another.
class ComparisonAnswer final : public AnswerOf<ImpactAnswer> {
public:
    ComparisonAnswer(std::shared_ptr<const ImpactAnswer> impact, double seconds)
        : AnswerOf(std::move(impact)), seconds_(seconds) {}

    [[nodiscard]] const Question& question() const override { return comparisonQuestion(); }
    [[nodiscard]] const StudySettings* settings() const override { return &content().settings.study; }
    [[nodiscard]] MeasuredPart part() const override {
        return {content().to, content().from, settings()->region, {}};
    }
    [[nodiscard]] const Warnings& warnings() const override { return content().study.total.warnings; }
    [[nodiscard]] double seconds() const override { return seconds_; }

    [[nodiscard]] std::shared_ptr<const Answer> updated(const Project&, const std::string& scenario,
                                                        const std::string& baseline) const override {
        if (scenario == content().to && baseline == content().from) return nullptr;
        auto impact = std::make_shared<ImpactAnswer>(content());
        impact->from = baseline;
        impact->to = scenario;
        return std::make_shared<ComparisonAnswer>(std::move(impact), seconds_);
    }
    [[nodiscard]] std::shared_ptr<const Answer> stated(Provenance provenance) const override {
        auto impact = std::make_shared<ImpactAnswer>(content());
        impact->provenance = std::move(provenance);
        return std::make_shared<ComparisonAnswer>(std::move(impact), seconds_);
    }

    [[nodiscard]] AnswerPage page(ShownAs show) const override {
        return makePage(content().study.total, computeFigures(content()), show);
    }
    [[nodiscard]] Result<std::string> command() const override { return makeRepeatCommand(content()); }
    [[nodiscard]] std::vector<CommandOption> drawnOptions(const AnswerFiles& how) const override {
        return drawnOfComparison(how);
    }
    [[nodiscard]] std::string json() const override { return impactJson(content()); }
    [[nodiscard]] SavedResult toSave(const Project& project) const override {
        return makeSavedResult(project, content());
    }
    [[nodiscard]] std::vector<std::string> fileNames(const AnswerFiles& how) const override {
        Provenance anyRegion;
        anyRegion.region = regionFileName;
        return impactFileNames(anyRegion, how.sheets);
    }
    [[nodiscard]] Result<std::vector<std::filesystem::path>> write(const City& city,
                                                                   const std::filesystem::path& folder,
                                                                   const AnswerFiles& how) const override {
        return writeImpactFiles(content(), {city}, how.scale, folder, how.rules,
                                how.sheets ? &how.book : nullptr, how.pictureWidth, how.legend);
    }
    [[nodiscard]] Result<std::shared_ptr<const Book>> layOut(const std::shared_ptr<const City>& city,
                                                             const AnswerFiles& how) const override {
        return keepWith(makeImpactBook(content(), {*city}, how.scale, how.book, how.legend), shared(), city);
    }

private:
    double seconds_;
};

Result<std::shared_ptr<const Answer>> computeComparison(const Asked& asked, Progress& progress,
                                                        const std::stop_token& stop) {
    const Stopwatch watch;
    const ImpactSettings settings{asked.settings, asked.byBuilding};
    auto study = runImpact(*asked.before, asked.loaded.read.city, settings, progress, stop,
                           enginesWith(asked.settings.engine));
    if (!study) return tl::make_unexpected(study.error());
    putBefore(study->total.warnings, asked.loaded.read.warnings);
    auto impact = std::make_shared<const ImpactAnswer>(
        ImpactAnswer{asked.baseline, asked.scenario, settings, asked.thresholdsMin, *std::move(study),
                     asked.provenance, keepOwnBuildings(asked.loaded.read.city, *asked.before)});
    return std::make_shared<ComparisonAnswer>(std::move(impact), watch.seconds());
}

AnswerPage pageOfSavedImpact(const SavedImpact& impact, const SavedContent&, ShownAs show) {
    return makePage(impact.impact, impact.figures, show);
}

}  // namespace

const Question& comparisonQuestion() {
    static const Question question{.key = "impact",
                                   .label = NM_TEXT("Comparison"),
                                   .fields = 2,
                                   .compute = computeComparison,
                                   .saved = savedMaps<SavedImpact>(pageOfSavedImpact, drawnOfComparison),
                                   .filed = FiledForm{"impact", "impact.json", "impact.pdf"}};
    return question;
}

}  // namespace noonmark
