#include "app/questions/glazing_question.h"

#include "app/report/files/glazing_files.h"
#include "core/base/memory_guard.h"

namespace noonmark {

namespace {

/// The options of the command line that ask for the same windows and sheets.
std::vector<CommandOption> repeatOptions(const GlazingQuestion& question, const BookSettings& sheets) {
    std::vector<CommandOption> options = makeRepeatOptions(question.settings.elements);
    options.insert(options.end(), question.repeat.begin(), question.repeat.end());
    for (CommandOption& option : makeRepeatOptions(sheets)) options.push_back(std::move(option));
    return options;
}

}  // namespace

bool isSame(const GlazingQuestion& a, const GlazingQuestion& b) {
    return isOfSameCase(a, b) && a.settings.zone == b.settings.zone && a.settings.year == b.settings.year &&
           a.settings.elements == b.settings.elements;
}

Result<GlazingAnswer> computeGlazingReview(const GlazingQuestion& question, Progress& progress,
                                           const std::stop_token& stop, const AnnounceGlazing& announce) {
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

Result<WrittenGlazing> writeGlazingReview(GlazingAnswer answer, const ReviewSource& source,
                                          const BookSettings& sheets, const std::filesystem::path& folder,
                                          bool byteOrderMark, Progress& progress,
                                          const std::stop_token& stop) {
    const GlazingQuestion& asked = answer.question;
    WrittenGlazing written{
        std::move(answer.study),
        {asked.from, asked.to, provenanceOf(source, asked), {}, repeatOptions(asked, sheets)},
        {}};
    addWarnings(written.study.warnings, source);
    auto files = writeGlazingFiles(
        {written.study, written.labels, *asked.before, *asked.after, source.project.reading->heights}, sheets,
        folder, byteOrderMark, source.outputs, progress, stop);
    if (!files) return tl::make_unexpected(files.error());
    written.files = *std::move(files);
    return written;
}

}  // namespace noonmark
