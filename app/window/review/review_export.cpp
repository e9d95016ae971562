#include "app/window/review/review_export.h"

#include "app/report/files/review_files.h"
#include "core/base/progress_share.h"
#include "core/engines/auto_engine.h"
#include "scenarios/project/project_provenance.h"

namespace noonmark {

Result<std::vector<std::filesystem::path>> exportReview(const ReviewExport& review,
                                                        const std::filesystem::path& folder,
                                                        Progress& progress, const std::stop_token& stop) {
    const ReviewQuestion& asked = review.answer->question;
    ReviewSettings settings = asked.settings;
    settings.timelines = true;
    ProgressShare computing(progress, 0, 2), writing(progress, 1, 2);
    auto study = runReview(asked.rule, *asked.before, *asked.after, asked.places, settings, AutoEngine(),
                           computing, stop);
    if (!study) return tl::make_unexpected(study.error());
    study->warnings.insert(study->warnings.end(), review.ofRules.begin(), review.ofRules.end());
    putBefore(study->warnings, review.project.reading->warnings);
    BookSettings sheets{{}, {}, review.project.sheets.titleBlock, review.project.sheets.units};
    if (sheets.titleBlock.date.empty()) sheets.titleBlock.date = describeToday().toStdString();
    const ReviewLabels labels{
        asked.from,
        asked.to,
        provenanceOf(review.project, review.file ? &*review.file : nullptr, {asked.to, asked.from, {}, {}}),
        {},
        makeRepeatOptions(sheets)};
    return writeReviewFiles(
        {*study, labels, *asked.before, *asked.after, asked.places, review.project.reading->heights},
        {sheets, false, review.outputs}, folder, writing, stop);
}

}  // namespace noonmark
