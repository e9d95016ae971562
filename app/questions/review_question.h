#pragma once

// The reviews by the rules of boards, which command line and window only ask and show: of places (this file),
// and of windows (glazing_question.h). Both are questions of the list in question.h.

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "app/questions/question.h"
#include "app/report/book/review/review_book.h"
#include "core/io/files/check_output.h"
#include "core/measures/places/place_screening.h"
#include "scenarios/project/project_file.h"

namespace noonmark {

/// The cities that a review compares.
struct ReviewedCities {
    std::string from, to;  ///< names of baseline and scenario
    std::shared_ptr<const City> before, after;
};

/// What is reviewed, and what the files of a review state and protect.
struct ReviewSource {
    Project project;
    std::optional<ProjectFile> file;   ///< none: the project was never saved, or the city was read from files
    std::optional<LoadedCity> loaded;  ///< that city, of which `project` is made
    Warnings ofRules;                  ///< of reading the library of rules
    OutputRules outputs;               ///< which files may be replaced
    std::optional<Provenance> stated{};  ///< what provenanceOf() returns; none: it has yet to be found
};

/// What the cities of a review were made from. Costs hashes (project_provenance.h) unless it is stated.
Provenance provenanceOf(const ReviewSource& source, const ReviewedCities& cities);
/// The warnings of a review between those of reading the city and those of the rules.
Warnings statedWarnings(Warnings ofReview, const ReviewSource& source);

/// A review of places, complete: it can be computed on another thread.
struct ReviewQuestion : ReviewedCities {
    Rule rule;
    std::vector<Place> places;  ///< or parcels, of a rule with lines
    ReviewSettings settings;
    /// About the places: lines of parcels with roads that were moved or not, places that were left out.
    Warnings warnings;
    /// As they were asked for: names, or "all". Empty: `places` by name.
    std::vector<std::string> named{};
    std::vector<CommandOption> repeat{};  ///< further options of the command that asks the same
    bool inReach = false;                 ///< `places` are those in reach of the places that are named
};

/// Whether both are the same rule with the same choices.
inline bool isSameRule(const Rule& a, const Rule& b) { return a.key == b.key && a.chosen == b.chosen; }

/// Whether two reviews ask the same rule, with the same choices, about the same buildings.
template <class Asked>
bool isOfSameCase(const Asked& a, const Asked& b) {
    return isSameRule(a.rule, b.rule) && a.before == b.before && a.after == b.after;
}

/// Whether both have the same answer.
bool isSame(const ReviewQuestion& a, const ReviewQuestion& b);

/// A question with its answer.
struct ReviewAnswer {
    ReviewQuestion question;
    ReviewStudy study;
    double seconds = 0;  ///< to compute it
    /// The place of study.places[review]; a parcel has two reviews.
    [[nodiscard]] const Place& placeOf(std::size_t review) const;
};

/// The same as an answer that is shown, listed and exported.
std::shared_ptr<const Answer> makeAnswer(std::shared_ptr<const ReviewAnswer> review,
                                         std::shared_ptr<const ReviewSource> source);

/// Whether a saved result has the verdicts of this question: of its rule, choices, year, scenarios and
/// places, by their names, whatever buildings these had. `orSome`: also of some of the places, those in
/// reach.
bool isReviewOf(const SavedResult& saved, const ReviewQuestion& question, bool orSome = false);
/// How long a saved review took, seconds; infinite where its version did not state it.
double secondsOfReview(const SavedResult& saved);

/// What reviewQuestion() computes, for use without an Answer. Errors of runReview().
Result<ReviewAnswer> computeReview(const ReviewQuestion& question, Progress& progress, std::stop_token stop);

/// Which places the shadow of the proposal reaches, tested as if it stood alone, by the days and hours of the
/// rule. Error: no sun in these hours; errors of screenPlaces() and computeRuleSun().
Result<std::vector<ScreenedPlace>> screen(const ReviewQuestion& question, Progress& progress,
                                          std::stop_token stop);

/// The places that the shadow of a proposal reaches.
struct PlacesInReach {
    std::vector<Place> places;                   ///< of those that the rule covers
    std::map<std::string, std::string> reasons;  ///< what screening found of each of these, by name
};
/// Error: what canScreen() refuses; errors of screen().
Result<PlacesInReach> findPlacesInReach(const ReviewQuestion& question, Progress& progress,
                                        const std::stop_token& stop);
/// Leaves out the others, each with a warning (`inReach`). Error: none is in reach; nothing is left out then.
Result<void> keepPlacesInReach(ReviewQuestion& question, const PlacesInReach& found);
/// Whether screening finds all places that the proposal shades: it adds a building, and the trees that the
/// rule counts are the same in both cities. Not of rules about parcels.
bool canScreen(const ReviewQuestion& question);

/// The warnings that its files state: those of reading the city first, those of the rules last.
Warnings statedWarnings(const ReviewAnswer& review, const ReviewSource& source);

/// Whether copyProject() can put a project's file into the folder of a report: it lies there, no file of its
/// name does, or a file with the same bytes. Another one is never replaced: it may be a project.
Result<void> checkCopy(const ProjectFile& file, const std::filesystem::path& folder);
/// Copies a project's file as it is on disk into the folder of a report, where `verify` looks for it. Error:
/// that of checkCopy(), or it cannot be copied.
Result<void> copyProject(const ProjectFile& file, const std::filesystem::path& folder);

}  // namespace noonmark
