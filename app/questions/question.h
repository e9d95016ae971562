#pragma once

#include <functional>
#include <optional>
#include <span>
#include <stop_token>

#include "app/input/load_city.h"
#include "app/questions/answer.h"
#include "core/study/by_place/sun_by_place.h"
#include "core/study/elements/place_elements.h"
#include "scenarios/impact/impact.h"

namespace noonmark {

struct ReviewQuestion;
struct GlazingQuestion;
struct ReviewSource;

/// What a user asks: of which city, where, when and how.
struct Asked {
    LoadedCity loaded;                   ///< the city of the scenario, with the warnings of reading
    std::shared_ptr<const City> before;  ///< of the baseline; of a comparison or of places only
    std::string scenario = existingCity;
    std::string baseline{};
    StudySettings settings{};
    std::optional<ElementSettings> points{};  ///< of points only
    std::optional<TimeWeights> weights{};     ///< of a score only
    std::vector<Place> places{};              ///< of sun by place only
    SunByPlaceSettings byPlace{};             ///< likewise; its study is `settings`
    PlaceSelection placesAsked{};             ///< likewise: how `places` were chosen
    /// Likewise: further scenarios. With no baseline they are compared with the scenario.
    std::vector<NamedCity> others{};
    /// Likewise: takes the seconds that the sweeps are expected to last, before they begin.
    std::function<void(double)> forecast{};
    std::shared_ptr<const ReviewQuestion> review{};      ///< of a review of places only: all of it
    std::shared_ptr<const GlazingQuestion> glazing{};    ///< of a review of windows only: all of it
    std::shared_ptr<const ReviewSource> reviewSource{};  ///< of both: what their files state
    ImpactSettings impact{};                             ///< of a comparison only; its study is `settings`
    Provenance provenance{};  ///< what the cities were made from; empty: stated later (Answer::stated)
};

struct SavedContent;
struct SavedSource;

/// What is shown and written of a question's results that were saved in a project.
struct SavedForm {
    /// The names of the files that it writes. None: those of the figures.
    std::function<std::vector<std::string>(const SavedContent&)> fileNames{};
    /// The page of what savedKinds() reads for the question's key (scenarios/project/results/saved_answer.h),
    /// else of its figures.
    std::function<AnswerPage(const SavedContent&, const LegendChoice&)> page{};
    /// None: it writes its figures. `sheets`: the PDF of its book, if one is wanted.
    std::function<Result<std::vector<std::filesystem::path>>(
        const SavedContent&, const SavedSource&, const std::filesystem::path& folder, const AnswerFiles&,
        const std::optional<std::string>& sheets)>
        write{};
    /// The book of sheets, which refers to the content and the source's city. None: that of its figures,
    /// which is among the files that it always writes.
    std::function<std::shared_ptr<const Book>(const SavedContent&, const SavedSource&, const AnswerFiles&)>
        book{};
    /// The options that its command needs to draw the same; none: it draws nothing that can be chosen.
    std::function<std::vector<CommandOption>(const AnswerFiles&)> drawnOptions{};
};

/// How its command files an answer, so that `noonmark-cli verify` finds the record and repeats it.
struct FiledForm {
    std::string_view command;   ///< of noonmark-cli: "review"
    std::string_view record;    ///< the JSON, attached to each PDF: "review.json"
    std::string_view report{};  ///< the PDF that the command writes without being asked; empty: none
    bool isBook = false;        ///< `report` is a book of sheets, with bookmarks
};

/// One thing that can be asked.
struct Question {
    std::string_view key;    ///< "impact": the kind of a saved result
    std::string_view label;  ///< of the running work, NM_TEXT: "Comparison"
    bool ofPoints = false;   ///< the time it takes depends on where points are
    double fields = 1;       ///< fields of shadow over the region that it computes, for the estimate of time
    /// Whether Run asks it again; else it is asked by a command of its own, and shown in front until the user
    /// returns to the study.
    bool ofRun = true;
    /// What it compares with is the baseline chosen in the window; else the user names both cities for it.
    bool ofBaseline = true;
    std::function<Result<std::shared_ptr<const Answer>>(const Asked&, Progress&, const std::stop_token&)>
        compute;
    /// None: its saved results come back as the numbers of `figures`, without a page.
    std::optional<SavedForm> saved{};
    std::span<const Figure> figures{};  ///< of a kind that savedKinds() lacks
    /// In a sentence, NM_TEXT: it asks for a city and the study's settings alone, so that a command of its
    /// key and an entry of the menu Study ask it. Empty: it has a command and a place in the window of its
    /// own.
    std::string_view help{};
    std::vector<std::string> fileNames{};  ///< that its answers write, where it has `help`
    std::optional<FiledForm> filed{};      ///< none: its files cannot be verified
};

/// What can be asked, in one list: it reads saved results back.
using Questions = std::span<const Question* const>;
Questions allQuestions();

const Question& studyQuestion();
const Question& comparisonQuestion();
const Question& scoreQuestion();
const Question& pointsQuestion();
const Question& byPlaceQuestion();
const Question& reviewQuestion();
const Question& glazingQuestion();

/// The answer of sun that was measured elsewhere. `asked`: with the region that was asked for.
std::shared_ptr<const Answer> makeByPlaceAnswer(SunOfCities sun, StudySettings asked);
/// The files that its answers write. `dates`: those of SunByPlaceSettings.
std::vector<std::string> byPlaceFileNames(bool withSheets, std::span<const CivilDate> dates);

}  // namespace noonmark
