#include "app/gui/docks/sheets/review_export.h"

#include "app/report/files/review_files.h"
#include "core/base/progress_share.h"
#include "core/engines/auto_engine.h"
#include "scenarios/project/project_provenance.h"

namespace noonmark {

namespace {

Result<std::shared_ptr<const ReviewStudy>> computeWithTimelines(const ReviewExport& review,
                                                                Progress& progress,
                                                                const std::stop_token& stop) {
    const ReviewQuestion& asked = review.answer->question;
    ReviewSettings settings = asked.settings;
    settings.timelines = settings.contributions = true;
    auto study = runReview(asked.rule, *asked.before, *asked.after, asked.places, settings, AutoEngine(),
                           progress, stop);
    if (!study) return tl::make_unexpected(study.error());
    study->warnings.insert(study->warnings.end(), review.ofRules.begin(), review.ofRules.end());
    putBefore(study->warnings, asked.moved);
    putBefore(study->warnings, review.project.reading->warnings);
    return std::make_shared<const ReviewStudy>(*std::move(study));
}

ReviewLabels labelsOf(const ReviewExport& review, const BookSettings& settings) {
    const ReviewQuestion& asked = review.answer->question;
    // Not the names of what was measured: of rules about parcels these are two belts for each.
    std::vector<std::string> names;
    for (const Place& place : asked.places) names.push_back(place.name);
    return {
        asked.from, asked.to,
        provenanceOf(review.project, review.file ? &*review.file : nullptr, {asked.to, asked.from, {}, {}}),
        std::move(names), makeRepeatOptions(settings)};
}

ReviewBookSource sourceOf(const ReviewExport& review, const ReviewStudy& study, const ReviewLabels& labels) {
    const ReviewQuestion& asked = review.answer->question;
    return {study,
            labels,
            *asked.before,
            *asked.after,
            asked.places,
            review.project.reading->heights,
            placesOfKind(review.project, PlaceKind::street)};
}

}  // namespace

Result<std::shared_ptr<const ReviewSheets>> layOutReview(const ReviewExport& review,
                                                         std::shared_ptr<const ReviewStudy> study,
                                                         const BookSettings& settings, Progress& progress,
                                                         const std::stop_token& stop) {
    ProgressShare computing(progress, 0, 2), drawing(progress, 1, 2);
    if (!study) {
        auto computed = computeWithTimelines(review, computing, stop);
        if (!computed) return tl::make_unexpected(computed.error());
        study = *std::move(computed);
    }
    auto sheets = std::make_shared<ReviewSheets>(
        ReviewSheets{settings, labelsOf(review, settings), std::move(study), {}});
    auto book = makeReviewBook(sourceOf(review, *sheets->study, sheets->labels), settings, drawing, stop);
    if (!book) return tl::make_unexpected(book.error());
    sheets->book = *std::move(book);
    return sheets;
}

Result<std::vector<std::filesystem::path>> writeReview(const ReviewExport& review, const ReviewSheets& sheets,
                                                       const std::filesystem::path& folder,
                                                       Progress& progress, const std::stop_token& stop) {
    return writeReviewFiles(sourceOf(review, *sheets.study, sheets.labels), sheets.book,
                            {false, review.outputs}, folder, progress, stop);
}

}  // namespace noonmark
