#include "app/questions/review_question.h"

#include <algorithm>
#include <limits>
#include <mutex>
#include <set>

#include "app/questions/saved_question.h"
#include "app/report/files/answer_files.h"
#include "core/base/memory_guard.h"
#include "core/base/progress.h"
#include "core/describe/field_values.h"
#include "core/describe/text.h"
#include "core/engines/auto_engine.h"
#include "core/engines/common/changed_buildings.h"
#include "core/measures/places/place_run.h"
#include "core/review/criteria/criterion_days.h"
#include "core/review/places/place_review.h"
#include "core/study/prepare_review.h"
#include "core/study/provenance/provenance.h"
#include "core/study/review_figures.h"
#include "core/study/text/error_text.h"
#include "core/study/text/review_text.h"
#include "scenarios/project/project_provenance.h"
#include "scenarios/project/results/save_result.h"
#include "scenarios/project/rule_parcels.h"

namespace noonmark {

namespace {

bool isAllOf(const Project& project, const ReviewQuestion& question) {
    const std::vector<Place> all = placesUnder(question.rule, project);
    return std::ranges::equal(all, question.places, {}, &Place::name, &Place::name);
}

constexpr const char* secondsKey = "compute_s";  // of a saved review

// Whatever the buildings.
bool asksSame(const ReviewQuestion& a, const ReviewQuestion& b) {
    return isSameRule(a.rule, b.rule) && a.places == b.places &&
           questionText(reviewFields().of(a.settings)) == questionText(reviewFields().of(b.settings));
}

ReviewLabels labelsOf(const ReviewQuestion& question, const ReviewSource& source,
                      const BookSettings& settings) {
    ReviewLabels labels{question.from, question.to, provenanceOf(source, question), question.named,
                        makeRepeatOptions(settings)};
    // Not the names of what was measured: of rules about parcels these are two belts for each.
    if (labels.places.empty() && isAllOf(source.project, question))
        labels.places = {"all"};
    else if (labels.places.empty())
        for (const Place& place : question.places) labels.places.push_back(place.name);
    labels.sheets.insert(labels.sheets.end(), question.repeat.begin(), question.repeat.end());
    if (question.inReach) labels.sheets.push_back({"--in-reach", {}});
    return labels;
}

ReviewBookSource bookSourceOf(const ReviewQuestion& question, const ReviewSource& source,
                              const ReviewStudy& study, const ReviewLabels& labels) {
    return {study,
            labels,
            *question.before,
            *question.after,
            question.places,
            source.project.reading->heights,
            placesOfKind(source.project, PlaceKind::street)};
}

using SharedStudy = std::shared_ptr<const ReviewStudy>;

/// The review as its files state it: with timelines, contributions and all warnings. A review that was asked
/// for both is not computed again.
Result<SharedStudy> computeForFiles(const ReviewAnswer& answered, const ReviewSource& source,
                                    Progress& progress, const std::stop_token& stop) {
    ReviewQuestion asked = answered.question;
    const bool isComplete = asked.settings.timelines && asked.settings.contributions;
    asked.settings.timelines = asked.settings.contributions = true;
    return (isComplete ? Result<ReviewAnswer>(answered) : computeReview(asked, progress, stop))
        .map([&](ReviewAnswer answer) {
            answer.study.warnings = statedWarnings(answer, source);
            return std::make_shared<const ReviewStudy>(std::move(answer.study));
        });
}

/// What the files of a review are made of. Its book refers to the rest: never changed once it is made.
struct ReviewSheets {
    ReviewLabels labels;
    SharedStudy study;
    Book book;
};

/// The verdicts of a rule on places.
class PlacesAnswer final : public AnswerOf<ReviewAnswer> {
public:
    PlacesAnswer(std::shared_ptr<const ReviewAnswer> review, std::shared_ptr<const ReviewSource> source)
        : AnswerOf(std::move(review)), source_(std::move(source)) {}

    [[nodiscard]] const Question& question() const override { return reviewQuestion(); }
    [[nodiscard]] const StudySettings* settings() const override { return nullptr; }
    [[nodiscard]] MeasuredPart part() const override { return {asked().to, asked().from, {}, {}}; }
    [[nodiscard]] const Warnings& warnings() const override { return content().study.warnings; }
    [[nodiscard]] double seconds() const override { return content().seconds; }
    [[nodiscard]] bool asksSameAs(const Answer& other) const override {
        const auto* review = other.as<ReviewAnswer>();
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
        auto answer = std::make_shared<PlacesAnswer>(shared(), std::move(source));
        answer->forFiles_ = forFiles_;
        return answer;
    }

    [[nodiscard]] AnswerPage page(const LegendChoice&) const override {
        const ReviewStudy& study = content().study;
        return makeReviewPage(countVerdicts(study), study.rule.name, asked().to, listDoubtful(study));
    }
    [[nodiscard]] std::vector<FigureLine> figures() const override {
        return listLines(placeVerdictFigures().of(countVerdicts(content().study)));
    }
    [[nodiscard]] Result<std::string> command() const override {
        return makeRepeatCommand(content().study, labelsOf(asked(), *source_, {}));
    }
    [[nodiscard]] std::vector<CommandOption> drawnOptions(const AnswerFiles& how) const override {
        return makeRepeatOptions(bookOf(how));
    }
    [[nodiscard]] std::string json() const override { return toJsonText(makeJson()); }
    [[nodiscard]] SavedResult toSave(const Project& project) const override {
        nlohmann::ordered_json json = makeJson();
        json.update(figuresJson(placeVerdictFigures().of(countVerdicts(content().study))));
        json["engine_settings"] = content().study.engine;
        json["region"] = "places";
        json[secondsKey] = seconds();
        return makeSavedResult(project, std::string(question().key), asked().to, asked().from,
                               std::move(json));
    }
    [[nodiscard]] std::vector<std::string> fileNames(const AnswerFiles&) const override {
        return reviewFileNames();
    }
    [[nodiscard]] Result<std::vector<std::filesystem::path>> write(const City&,
                                                                   const std::filesystem::path& folder,
                                                                   const AnswerFiles& how) const override {
        NoProgress quiet;
        Progress& progress = how.progress ? *how.progress : quiet;
        ProgressShare layingOut(progress, 0, 2), writing(progress, 1, 2);
        if (const auto may = checkOutputs(folder, reviewFileNames(), how.rules); !may)
            return tl::make_unexpected(may.error());
        const auto sheets = makeSheets(how, layingOut);
        if (!sheets) return tl::make_unexpected(sheets.error());
        return writeReviewFiles(bookSourceOf(asked(), *source_, *(*sheets)->study, (*sheets)->labels),
                                (*sheets)->book, {how.byteOrderMark, how.rules}, folder, writing, how.stop);
    }
    [[nodiscard]] Result<std::shared_ptr<const Book>> layOut(const std::shared_ptr<const City>&,
                                                             const AnswerFiles& how) const override {
        NoProgress quiet;
        return makeSheets(how, how.progress ? *how.progress : quiet)
            .map([](const std::shared_ptr<const ReviewSheets>& sheets) {
                return std::shared_ptr<const Book>(sheets, &sheets->book);
            });
    }

private:
    /// The review as files state it takes long; it is computed when the first of them is laid out.
    struct ForFiles {
        std::mutex mutex;
        std::shared_ptr<const ReviewStudy> study;
    };

    [[nodiscard]] Result<SharedStudy> findStudy(Progress& progress, const std::stop_token& stop) const {
        const std::lock_guard lock(forFiles_->mutex);
        if (forFiles_->study) return forFiles_->study;
        auto study = computeForFiles(content(), *source_, progress, stop);
        if (study) forFiles_->study = *study;
        return study;
    }

    [[nodiscard]] Result<std::shared_ptr<const ReviewSheets>> makeSheets(const AnswerFiles& how,
                                                                         Progress& progress) const {
        ProgressShare computing(progress, 0, 2), drawing(progress, 1, 2);
        const auto study = findStudy(computing, how.stop);
        if (!study) return tl::make_unexpected(study.error());
        const BookSettings settings = bookOf(how);
        auto sheets =
            std::make_shared<ReviewSheets>(ReviewSheets{labelsOf(asked(), *source_, settings), *study, {}});
        auto book = makeReviewBook(bookSourceOf(asked(), *source_, *sheets->study, sheets->labels), settings,
                                   drawing, how.stop);
        if (!book) return tl::make_unexpected(book.error());
        sheets->book = *std::move(book);
        return sheets;
    }

    [[nodiscard]] const ReviewQuestion& asked() const { return content().question; }
    [[nodiscard]] nlohmann::ordered_json makeJson() const {
        return reviewJson(content().study, labelsOf(asked(), *source_, {}));
    }

    std::shared_ptr<const ReviewSource> source_;
    std::shared_ptr<ForFiles> forFiles_ = std::make_shared<ForFiles>();
};

Result<std::shared_ptr<const Answer>> computePlaces(const Asked& asked, Progress& progress,
                                                    const std::stop_token& stop) {
    return computeReview(*asked.review, progress, stop)
        .map([&](ReviewAnswer review) -> std::shared_ptr<const Answer> {
            return std::make_shared<PlacesAnswer>(std::make_shared<const ReviewAnswer>(std::move(review)),
                                                  asked.reviewSource);
        });
}

// Its JSON is that of review.json, with the counts of verdicts.
AnswerPage pageOfSavedReview(const SavedContent& saved, const LegendChoice&) {
    const auto json = nlohmann::ordered_json::parse(saved.result->settings);
    std::vector<CriticalPlace> doubtful;
    for (const Verdict verdict : {Verdict::fail, Verdict::borderline})
        for (const auto& place : json.at("places"))
            if (place.at("verdict") == nameOf(verdict))
                doubtful.push_back({place.at("name"), place.at("reason")});
    return makeReviewPage(readFigures(placeVerdictFigures(), json), json.at("rule_name"),
                          saved.result->scenario, doubtful);
}

}  // namespace

const Question& reviewQuestion() {
    static const Question question{.key = "review",
                                   .label = NM_TEXT("Review"),
                                   .ofRun = false,
                                   .ofBaseline = false,
                                   .compute = computePlaces,
                                   .saved = SavedForm{.page = pageOfSavedReview},
                                   .figures = placeVerdictFigures().rows(),
                                   .filed = FiledForm{"review", "review.json", "sheets.pdf", true}};
    return question;
}

std::shared_ptr<const Answer> makeAnswer(std::shared_ptr<const ReviewAnswer> review,
                                         std::shared_ptr<const ReviewSource> source) {
    return std::make_shared<PlacesAnswer>(std::move(review), std::move(source));
}

Provenance provenanceOf(const ReviewSource& source, const ReviewedCities& cities) {
    if (source.stated) return *source.stated;
    if (source.loaded) return provenanceOf(*source.loaded);
    return provenanceOf(source.project, source.file ? &*source.file : nullptr,
                        {cities.to, cities.from, {}, {}});
}

Warnings statedWarnings(Warnings ofReview, const ReviewSource& source) {
    ofReview.insert(ofReview.end(), source.ofRules.begin(), source.ofRules.end());
    prependWarnings(ofReview, source.project.reading->warnings);
    return ofReview;
}

namespace {

// Of a rule with lines each parcel has two reviews, with names of their own.
bool hasPlaces(const nlohmann::json& saved, const ReviewQuestion& question, bool orSome) {
    if (question.rule.receivers.hasLines()) return saved.size() == 2 * question.places.size();
    std::set<std::string> then, now;
    for (const auto& place : saved) then.insert(place.at("name").get<std::string>());
    for (const Place& place : question.places) now.insert(place.name);
    return orSome ? std::ranges::includes(now, then) : then == now;
}

}  // namespace

bool isReviewOf(const SavedResult& saved, const ReviewQuestion& question, bool orSome) try {
    if (saved.kind != reviewQuestion().key || saved.scenario != question.to ||
        saved.baseline != question.from)
        return false;
    const auto json = nlohmann::json::parse(saved.settings);
    return json.at("rule") == question.rule.key && json.at("year") == question.settings.year &&
           json.at("choices").get<decltype(Rule::chosen)>() == question.rule.chosen &&
           hasPlaces(json.at("places"), question, orSome);
} catch (const nlohmann::json::exception&) {  // of another version, or damaged
    return false;
}

double secondsOfReview(const SavedResult& saved) try {
    return nlohmann::json::parse(saved.settings).at(secondsKey).get<double>();
} catch (const nlohmann::json::exception&) {
    return std::numeric_limits<double>::infinity();
}

bool isSame(const ReviewQuestion& a, const ReviewQuestion& b) { return isOfSameCase(a, b) && asksSame(a, b); }

const Place& ReviewAnswer::placeOf(std::size_t review) const {
    const std::size_t each = question.rule.receivers.hasLines() ? 2 : 1;
    return question.places[std::min(review / each, question.places.size() - 1)];
}

Result<ReviewAnswer> computeReview(const ReviewQuestion& given, Progress& progress, std::stop_token stop) {
    const Stopwatch watch;
    ReviewQuestion question = given;
    if (question.to == question.from) question.rule = dropComparisons(std::move(question.rule));
    return guardMemory({.what = "a review"},
                       [&] {
                           return runReview(question.rule, *question.before, *question.after, question.places,
                                            question.settings, AutoEngine(), progress, std::move(stop));
                       })
        .map([&](ReviewStudy study) {
            return ReviewAnswer{question, std::move(study), watch.seconds()};
        });
}

Result<std::vector<ScreenedPlace>> screen(const ReviewQuestion& question, Progress& progress,
                                          std::stop_token stop) {
    const auto sun = computeRuleSun(
        question.rule, {observerOfPlaces(*question.before), question.settings.zone, question.settings.year},
        stop);
    if (!sun) return tl::make_unexpected(sun.error());
    if (sun->sun.steps.empty())
        return failure("No sun in these hours", question.rule.name, "Choose another rule or year");
    return screenPlaces(*question.before, *question.after, question.places, sun->sun, {}, AutoEngine(),
                        progress, std::move(stop));
}

namespace {

// Where a scenario adds no building, screenPlaces() says so.
Result<void> checkScreening(const ReviewQuestion& question) {
    if (question.rule.receivers.hasLines())
        return unsupported("The rule is about the surroundings of parcels", "--in-reach", "Name the lots");
    if (question.rule.occluders.trees != RuleTrees::without &&
        !haveSameTrees(*question.before, *question.after))
        return unsupported("The rule counts trees, and the scenario plants or fells some", "--in-reach",
                           "Leave out --in-reach");
    return {};
}

}  // namespace

bool canScreen(const ReviewQuestion& question) {
    return checkScreening(question) &&
           !findChangedBuildings(question.before->buildings, question.after->buildings).added.empty();
}

Result<PlacesInReach> findPlacesInReach(const ReviewQuestion& question, Progress& progress,
                                        const std::stop_token& stop) {
    if (const auto may = checkScreening(question); !may) return tl::make_unexpected(may.error());
    ReviewQuestion covered = question;
    std::erase_if(covered.places, [&](const Place& place) { return !covers(question.rule, place.kind); });
    const auto screened = screen(covered, progress, stop);
    if (!screened) return tl::make_unexpected(screened.error());
    PlacesInReach found;
    for (const ScreenedPlace& one : *screened) {
        Place& place = covered.places[one.place];
        found.reasons[place.name] = one.reason;
        if (one.result == ScreeningResult::reached) found.places.push_back(std::move(place));
    }
    return found;
}

Result<void> keepPlacesInReach(ReviewQuestion& question, const PlacesInReach& found) {
    if (found.places.empty())
        return failure(NM_TEXT("The proposal's shadow reaches no place in the rule's hours"),
                       question.rule.name, NM_TEXT("Review all places to have that stated for each"));
    std::set<std::string_view> kept;
    for (const Place& place : found.places) kept.insert(place.name);
    for (const Place& place : question.places) {
        if (kept.contains(place.name)) continue;
        const bool isCovered = found.reasons.contains(place.name);
        question.warnings.push_back({WarningKind::leftOut,
                                     isCovered ? "the proposal's shadow does not reach it in the rule's hours"
                                               : "the rule does not cover places of its kind",
                                     place.name});
    }
    question.places = found.places;
    question.inReach = true;
    return {};
}

Warnings statedWarnings(const ReviewAnswer& review, const ReviewSource& source) {
    Warnings warnings = review.study.warnings;
    prependWarnings(warnings, review.question.warnings);
    return statedWarnings(std::move(warnings), source);
}

Result<void> checkCopy(const ProjectFile& file, const std::filesystem::path& folder) {
    const std::filesystem::path copy = folder / file.path().filename();
    std::error_code ignored;
    if (!std::filesystem::exists(copy, ignored) || std::filesystem::equivalent(file.path(), copy, ignored))
        return {};
    const auto there = describeInputFile(copy), here = describeInputFile(file.path());
    if (there && here && there->sha256 == here->sha256) return {};
    return failure("Another file has the name of the project's copy", copy.string(),
                   "Remove it, or choose another folder");
}

Result<void> copyProject(const ProjectFile& file, const std::filesystem::path& folder) {
    if (auto may = checkCopy(file, folder); !may) return may;
    const std::filesystem::path copy = folder / file.path().filename();
    std::error_code error;
    if (std::filesystem::exists(copy, error)) return {};
    std::filesystem::copy_file(file.path(), copy, error);
    if (error)
        return failure("The project cannot be copied beside the report", copy.string(), error.message());
    return {};
}

}  // namespace noonmark
