#include "app/input/all_engines.h"
#include "app/questions/saved_question.h"
#include "app/report/book/answer_books.h"
#include "app/report/files/answer_files.h"
#include "app/report/sheets/answer_reports.h"
#include "core/base/progress.h"
#include "core/describe/text.h"
#include "core/study/review_study.h"
#include "core/study/text/region_text.h"
#include "scenarios/project/results/save_result.h"
#include "scenarios/weights/score_text.h"

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

    [[nodiscard]] AnswerPage page(const LegendChoice& shown) const override {
        return makePage(content(), shown);
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
        return bundleBook(makeImpactBook(content(), {*city}, how.scale, how.book, how.legend), shared(),
                          city);
    }

private:
    double seconds_;
};

Result<std::shared_ptr<const Answer>> computeComparison(const Asked& asked, Progress& progress,
                                                        const std::stop_token& stop) {
    const Stopwatch watch;
    ImpactSettings settings = asked.impact;
    settings.study = asked.settings;
    auto study = runImpact(*asked.before, asked.loaded.read.city, settings, progress, stop,
                           enginesWith(asked.settings.engine));
    if (!study) return tl::make_unexpected(study.error());
    prependWarnings(study->total.warnings, asked.loaded.read.warnings);
    auto impact = std::make_shared<ImpactAnswer>(
        ImpactAnswer{asked.baseline, asked.scenario, settings, *std::move(study), asked.provenance,
                     keepOwnBuildings(asked.loaded.read.city, *asked.before),
                     keepOwnBuildings(*asked.before, asked.loaded.read.city)});
    impact->beyond = findBeyond(*impact);
    return std::make_shared<ComparisonAnswer>(std::move(impact), watch.seconds());
}

AnswerPage pageOfSavedImpact(const SavedImpact& impact, const SavedContent&, const LegendChoice& shown) {
    return makePage(impact.impact, impact.figures, shown.show);
}

void addSavedComparison(SavedMapBook& book, const SavedImpact& impact, const SavedContent&) {
    book.comparison = &impact;
    if (impact.sides) return;
    book.note = {heading(QStringLiteral("Not shown")),
                 body(QStringLiteral("The shadow of both scenarios side by side: the version that saved it "
                                     "stored the change alone. Compared again, it has them."))};
}

}  // namespace

const Question& comparisonQuestion() {
    static const Question question{
        .key = "impact",
        .label = NM_TEXT("Comparison"),
        .fields = 2,
        .compute = computeComparison,
        .saved = savedMaps<SavedImpact>(pageOfSavedImpact, drawnOfComparison, addSavedComparison),
        .filed = FiledForm{"impact", "impact.json", "impact.pdf"}};
    return question;
}

namespace {

std::vector<CommandOption> drawnOfScore(const AnswerFiles& how) {
    return listLegendOptions(how.legend, true);
}

/// Wanted shade weighed against unwanted shadow in one scenario.
class WeighedAnswer final : public AnswerOf<ScoreAnswer> {
public:
    WeighedAnswer(std::shared_ptr<const ScoreAnswer> score, double seconds)
        : AnswerOf(std::move(score)), seconds_(seconds) {}

    [[nodiscard]] const Question& question() const override { return scoreQuestion(); }
    [[nodiscard]] const StudySettings* settings() const override { return &content().settings; }
    [[nodiscard]] MeasuredPart part() const override {
        return {content().scenario, {}, settings()->region, content().weights};
    }
    [[nodiscard]] const Warnings& warnings() const override { return content().score.warnings; }
    [[nodiscard]] double seconds() const override { return seconds_; }

    [[nodiscard]] std::shared_ptr<const Answer> updated(const Project&, const std::string& scenario,
                                                        const std::string&) const override {
        if (scenario == content().scenario) return nullptr;
        auto score = std::make_shared<ScoreAnswer>(content());
        score->scenario = scenario;
        return std::make_shared<WeighedAnswer>(std::move(score), seconds_);
    }
    [[nodiscard]] std::shared_ptr<const Answer> stated(Provenance provenance) const override {
        auto score = std::make_shared<ScoreAnswer>(content());
        score->provenance = std::move(provenance);
        return std::make_shared<WeighedAnswer>(std::move(score), seconds_);
    }

    [[nodiscard]] AnswerPage page(const LegendChoice& shown) const override {
        const Score& score = content().score;
        const ShadedScore* with = findColumn(score, shown.trees);
        AnswerPage page = with ? makePage(*with, with->months, content().scenario, shown.show)
                               : makePage(score, score.months, content().scenario, shown.show);
        if (!score.withTrees.empty()) page.findings.push_back(nameColumn(columnOf(score, shown.trees)));
        return page;
    }
    [[nodiscard]] Result<std::string> command() const override { return makeRepeatCommand(content()); }
    [[nodiscard]] std::vector<CommandOption> drawnOptions(const AnswerFiles& how) const override {
        return drawnOfScore(how);
    }
    [[nodiscard]] std::string json() const override { return scoreJson(content()); }
    [[nodiscard]] SavedResult toSave(const Project& project) const override {
        return makeSavedResult(project, content());
    }
    [[nodiscard]] std::vector<std::string> fileNames(const AnswerFiles& how) const override {
        Provenance anyRegion;
        anyRegion.region = regionFileName;
        return scoreFileNames(anyRegion, how.sheets);
    }
    [[nodiscard]] Result<std::vector<std::filesystem::path>> write(const City& city,
                                                                   const std::filesystem::path& folder,
                                                                   const AnswerFiles& how) const override {
        return writeScoreFiles(content(), {city}, folder, how.rules, how.sheets ? &how.book : nullptr,
                               how.pictureWidth, how.legend);
    }
    [[nodiscard]] Result<std::shared_ptr<const Book>> layOut(const std::shared_ptr<const City>& city,
                                                             const AnswerFiles& how) const override {
        return bundleBook(makeScoreBook(content(), {*city}, how.book, how.legend), shared(), city);
    }

private:
    double seconds_;
};

Result<std::shared_ptr<const Answer>> computeWeighed(const Asked& asked, Progress& progress,
                                                     const std::stop_token& stop) {
    const Stopwatch watch;
    ProgressShare whole(progress, 0, 1);  // forwards no partial results: they would cover one month only
    auto score = runScore(asked.loaded.read.city, asked.settings, *asked.weights, whole, stop,
                          enginesWith(asked.settings.engine));
    if (!score) return tl::make_unexpected(score.error());
    prependWarnings(score->warnings, asked.loaded.read.warnings);
    auto answer = std::make_shared<const ScoreAnswer>(
        ScoreAnswer{asked.scenario, asked.settings, *asked.weights, *std::move(score), asked.provenance});
    return std::make_shared<WeighedAnswer>(std::move(answer), watch.seconds());
}

AnswerPage pageOfSavedScore(const SavedScore& score, const SavedContent& saved, const LegendChoice& shown) {
    return makePage(score.score, score.score.months, saved.result->scenario, shown.show);
}

void addSavedScore(SavedMapBook& book, const SavedScore& score, const SavedContent&) {
    book.score = &score.score;
    book.weights = score.weights;
}

}  // namespace

const Question& scoreQuestion() {
    static const Question question{
        .key = "score",
        .label = NM_TEXT("Score"),
        .ofRun = false,
        .compute = computeWeighed,
        .saved = savedMaps<SavedScore>(pageOfSavedScore, drawnOfScore, addSavedScore),
        .filed = FiledForm{"score", "score.json", "score.pdf"}};
    return question;
}

}  // namespace noonmark
