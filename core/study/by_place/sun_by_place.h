#pragma once

// The folder core/study/by_place answers how sunny places are over a period: runSunByPlace() (this file)
// measures all of them in one sweep over the union of their cells, sun_by_place_text.cpp writes the figures.

#include <chrono>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/describe/answer_page.h"
#include "core/describe/choice.h"
#include "core/describe/command_options.h"
#include "core/describe/field.h"
#include "core/describe/figure.h"
#include "core/describe/shown_as.h"
#include "core/io/elements/write_elements.h"
#include "core/measures/colour_scale.h"
#include "core/measures/shown_error.h"
#include "core/receivers/place.h"
#include "core/study/study.h"

namespace noonmark {

struct SunByPlaceSettings {
    static constexpr double maxHours = 24;
    static constexpr std::size_t maxDates = 31;
    static constexpr double maxLossMin = 1440;

    StudySettings study;           ///< its region is replaced by the places; receivers stand on the ground
    double enoughHours = 2;        ///< hours of sun a day that are enough, 0 to 24
    std::vector<CivilDate> dates;  ///< days on which the area with less is stated; any, at most 31
    double lossMin = 15;           ///< a cell that loses more minutes a day counts as lost; 0 to 1440
    /// Of places with fewer than smallPlaceCells cells, whose means larger ones miss by up to an hour; as
    /// large as those of the study or larger: no others.
    double smallCellM = 0.5;
    static constexpr double smallPlaceCells = 25;

    bool operator==(const SunByPlaceSettings&) const = default;
};

/// All but those of the study.
const Fields<SunByPlaceSettings>& sunByPlaceFields();

/// How places were chosen.
struct PlaceSelection {
    std::vector<CommandOption> options;  ///< of the command by-place
    bool ofProject = false;              ///< only its project has them
};

/// A cell of a place.
struct SunOfCell {
    float hours = 0;       ///< of sun a day, mean over the days
    float share = 1;       ///< of the cell that counts as the place's open ground; may be above 1
    bool isInside = true;  ///< its centre lies in the place
};

/// Whether a place has figures, and why not.
enum class PlaceStatus {
    measured,      ///< it has figures
    builtOver,     ///< buildings stand on all of it
    betweenCells,  ///< no cell has its centre on its open ground
};
/// With the keys of JSON; none for measured.
std::span<const Choice<PlaceStatus>> placeStatusChoices();
/// Their label; empty where it is measured.
std::string_view describe(PlaceStatus status);

/// What to know about the figures of a place.
enum class PlaceRemark {
    beyondTerrain,  ///< on some of it the nearest elevation of the terrain is taken
    onWater,        ///< most of it is water; measured at its surface
};
/// With the keys of JSON.
std::span<const Choice<PlaceRemark>> placeRemarkChoices();

/// The month of a key as in SunByPlace::months: "2026-01". Not ok() where the text is another.
std::chrono::year_month monthOfKey(std::string_view key);

/// Three months of the year.
struct SunSeason {
    std::string key;    ///< of columns: "dec_feb"
    std::string label;  ///< "Dec to Feb (winter)"; within the tropics "Dec to Feb"
};

/// The sun of one place. Hours are hours of sun a day; NaN: no cell.
struct SunOfPlace {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    std::size_t cells = 0;  ///< with their centre in the place
    double areaM2 = 0;      ///< of open ground, each cell by its exact share
    double meanHours = none, minHours = none, maxHours = none;  ///< over the cells, mean over the days
    double enoughShare = none;                                  ///< of the area, with enoughHours or more
    double cellM = 0;                                           ///< side of its cells; 0: none
    PlaceStatus status = PlaceStatus::measured;
    std::vector<PlaceRemark> remarks;  ///< about its figures
    std::vector<double> seasonHours;   ///< as monthHours; of SunByPlace::seasons
    std::vector<double> monthHours;    ///< mean over the cells and the month's days; of SunByPlace::months
    std::vector<double> dateHours;     ///< mean over the cells; of SunByPlaceSettings::dates
    std::vector<double>
        belowShare;  ///< of the area, with less than enoughHours; of SunByPlaceSettings::dates
    std::vector<SunOfCell> ofCells;  ///< also those beside it that count for some of it
    /// Hours of sun of the same cells on each of SunByPlaceSettings::dates.
    std::vector<std::vector<float>> dateHoursOfCells;
};

/// The sun of the places where trees are measured, too: hours of sun of which crowns take their share, on the
/// same cells. Remarks and why there are no figures stand with the sun without trees.
struct SunWithTrees {
    TreeColumns column = TreeColumns::seasonal;  ///< evergreen or seasonal
    std::vector<SunOfPlace> sun;                 ///< of each place
};

/// The sun of the cells that were sampled in places, by the engine and by rays: the error of a share of the
/// area for any hours that are enough.
struct SampledShares {
    struct Cell {
        double sunMin = 0, referenceMin = 0;  ///< a day
        double share = 0;                     ///< of the place's sampled cells; their sum is 1
    };
    std::string key;  ///< of the error: "place_enough"
    std::string of;   ///< of the error: a date, a column of trees
    std::vector<std::vector<Cell>> places;
};

/// Their labels, and why there are no figures: what a place is listed with. Empty: nothing to remark.
std::vector<std::string_view> listRemarks(const SunOfPlace& of);

struct SunByPlace {
    std::string name;  ///< of the city, where several are compared: "Tower"
    City city;
    SunByPlaceSettings settings;
    std::vector<Place> places;
    std::optional<PlaceSelection> asked;  ///< set by the caller, with the provenance
    std::vector<SunOfPlace> sun;          ///< of each place, without trees
    /// As StudySettings::trees asks, evergreens first. Empty: no tree reaches a place in any of the cities.
    std::vector<SunWithTrees> withTrees;
    std::string treesHow;                            ///< how they were measured, in words
    std::vector<std::optional<std::size_t>> partOf;  ///< of each place (findWholes()); none: for itself
    std::vector<std::string> months;                 ///< "2026-01"
    std::vector<SunSeason> seasons;                  ///< that the period has days of, December first
    double possibleHours = 0;           ///< a day with the sun above the horizon, mean over the days
    ShadowField field;                  ///< gross shadow on the union of the places' cells; no longest runs
    std::optional<SampledError> error;  ///< of cells, against the ray reference
    std::vector<std::optional<SampledError>> dateErrors;  ///< likewise; of SunByPlaceSettings::dates
    /// Of each quantity that is shown, on a sample; of a compared city its changes, too. None: not measured.
    std::vector<ShownError> errors;
    std::vector<SampledShares> sampledShares;  ///< what those of shares were found from; not saved
    SunSteps daylight;                         ///< the period's sun
    std::map<std::string, double> seconds;     ///< by stage, "total", and "forecast" of it before the sweeps
    Warnings warnings;                         ///< places without cells among them
    Provenance provenance;                     ///< set by the caller
};

/// What a place gets in one city, set against another. Losses are positive; NaN: no cell.
struct SunChange {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    double meanHours = none;   ///< more sun a day, mean over the place; negative: less
    double maxLossMin = none;  ///< a day, at the cell that loses most; 0: no cell loses
    double maxGainMin = none;  ///< likewise
    double lostShare = none;   ///< of the area, which loses more than SunByPlaceSettings::lossMin a day
};

/// The same places in another city.
struct ComparedSun {
    SunByPlace sun;
    std::vector<SunChange> changes;                        ///< of each place, without trees
    std::vector<std::vector<SunChange>> changesWithTrees;  ///< of each of sun.withTrees
};

/// The places in a city and, on the same cells, in others.
struct SunOfCities {
    SunByPlace baseline;
    std::vector<ComparedSun> compared;  ///< none: nothing is compared
};

/// The last of the cities whose places were measured: the scenario, or the only city.
inline const SunByPlace& shownCity(const SunOfCities& sun) {
    return sun.compared.empty() ? sun.baseline : sun.compared.back().sun;
}

struct NamedCity {
    std::string name;
    City city;
};

/// What was measured: the study's period, or the same hours of one of the dates.
Period periodOf(const SunByPlaceSettings& settings, const std::optional<CivilDate>& date);

/// How much sun the places of a city get. Places without a cell on open ground are listed as warnings, with
/// NaN as figures. Error: no place, a setting out of range, an engine that sums no months; errors of
/// runStudy(). Stops with cancelled() within 0.2 s. Cost: one field with its months over the union of the
/// places, and a day for each date.
Result<SunByPlace> runSunByPlace(const City& city, std::vector<Place> places,
                                 const SunByPlaceSettings& settings, Progress& progress, std::stop_token stop,
                                 const EngineList& engines = coreEngines());

/// The same in several cities of one project, on cells that are open ground in all of them; the first is the
/// baseline. `forecast` takes the seconds that all of it is expected to take, within a factor of two, once
/// the cells are known. Cost: as of runSunByPlace() for the first city, and of the others where their changed
/// buildings cast shadow.
Result<SunOfCities> compareSunByPlace(std::span<const NamedCity> cities, std::vector<Place> places,
                                      const SunByPlaceSettings& settings, Progress& progress,
                                      std::stop_token stop, const EngineList& engines = coreEngines(),
                                      const std::function<void(double)>& forecast = {});

/// What compareSunByPlace() will take.
struct SunForecast {
    double seconds = 0;     ///< within a factor of two
    std::size_t cells = 0;  ///< of all places together, without the finer ones of small places
    std::size_t steps = 0;  ///< of the sun over the period
    std::string engine;     ///< key; the automatic choice is resolved
};

/// Errors as those of compareSunByPlace(). Costs placing the cells and the sun's steps: 0.1 s, of a year in
/// steps of a minute 1 s.
Result<SunForecast> forecastSunByPlace(std::span<const NamedCity> cities, const std::vector<Place>& places,
                                       const SunByPlaceSettings& settings, const std::stop_token& stop,
                                       const EngineList& engines = coreEngines());

/// Of the places of one tile, of which the whole answer has more: under the sun of `observer`, without a
/// check of the terrain or a question about the zone, which are about the whole. Places without a cell have
/// no figures, even where none has any.
Result<SunOfCities> measurePlacesOfTile(std::span<const NamedCity> cities, std::vector<Place> places,
                                        const SunByPlaceSettings& settings, const Observer& observer,
                                        Progress& progress, std::stop_token stop,
                                        const EngineList& engines = coreEngines());

/// What all places have in common, without figures: months, seasons, daylight, the hours that are possible,
/// which place is part of which. `sun`: has a city, settings and places; its region becomes that of the
/// places. Error: the sun cannot be computed.
Result<void> prepareSunByPlace(SunByPlace& sun, const Observer& observer, const std::stop_token& stop);

/// All places as one: the hours of the period and of its months and the share with enough, each place by its
/// area; NaN: none has a cell. A place that is part of another counts twice.
SunOfPlace averagePlaces(const SunByPlace& sun);

/// Share of the area of a place with so many hours of sun a day or more, from its cells; NaN: none is known.
double computeEnoughShare(const SunOfPlace& of, double hours);
/// Share of the area with fewer hours of sun on a date, an index of SunByPlaceSettings::dates; likewise.
double computeBelowShare(const SunOfPlace& of, std::size_t date, double hours);

/// The same where so many hours of sun a day are enough: its setting and the shares of all places follow.
/// None: its cells are not known, as of a saved one. O(cells), without a sweep.
std::optional<SunOfCities> withEnough(const SunOfCities& sun, double hours);

/// The columns of an answer: without trees, and those that any of its cities was measured with, evergreens
/// first. In sun_in_column.cpp, as the following two.
std::vector<TreeColumns> listSunColumns(const SunByPlace& baseline, std::span<const ComparedSun> compared);
std::vector<TreeColumns> listSunColumns(const SunOfCities& sun);

/// What each place gets in a city with trees counted as in `column`. A city that lacks the column has no tree
/// that reaches a place: its sun without trees.
const std::vector<SunOfPlace>& sunInColumn(const SunByPlace& city, TreeColumns column);

/// The answer with the sun of one column, its changes and its errors in place of those without trees, and no
/// columns besides: for whatever states one sun of each place. None: no city has such a column, or it is that
/// without trees, which the answer states itself. Copies the answer.
std::optional<SunOfCities> inColumn(const SunOfCities& sun, TreeColumns column);

/// Whether both state the same shadow on the same cells: they differ at most in the hours that are enough.
/// False where cells are not known. O(cells)
bool haveSameShadow(const SunOfCities& one, const SunOfCities& other);

/// `before` and `after` have the same places and cells. With trees: of each column of `after`.
std::vector<SunChange> computeChanges(const SunByPlace& before, const SunByPlace& after);
std::vector<std::vector<SunChange>> computeChangesWithTrees(const SunByPlace& before,
                                                            const SunByPlace& after);

const Figures<SunOfPlace>& sunOfPlaceFigures();
const Figures<SunChange>& sunChangeFigures();
/// The same with trees of a column: "hours_mean_evergreen", "change_hours_evergreen".
std::span<const Figure> sunFiguresWithTrees(TreeColumns column);
std::span<const Figure> changeFiguresWithTrees(TreeColumns column);

/// How the sun of a day is stated: in hours, or as minutes of shadow, which are the rest of the sunlit time.
struct SunOrShadow {
    ShownAs show = ShownAs::sun;
    double possibleHours = SunOfPlace::none;  ///< a day with the sun up; NaN: not known, so sun is stated

    [[nodiscard]] bool isSun() const;
    [[nodiscard]] Amount amount(double sunHours) const;
};

/// Hours a day with the sun above the horizon on the days that `has` names; NaN: the period has none of them,
/// or its days are not known, as of a saved answer.
double possibleHoursOn(const SunByPlace& sun, const std::function<bool(const CivilDate&)>& has);

/// What they say: how many places have less than enough, hours on average, what each compared city takes,
/// and the months.
AnswerPage makePage(const SunOfCities& sun, ShownAs show = ShownAs::sun);

/// What they say of one place: its hours, those of the dates, what each compared city takes, and its months.
AnswerPage makePage(const SunOfCities& sun, std::size_t place, ShownAs show = ShownAs::sun);

/// A part of the period that figures are stated of.
struct SunPart {
    enum class Of { season, month, date };
    std::string key;  ///< of columns: "dec_feb", "2026-01", "2026-12-21"
    Of of = Of::month;
    std::size_t index = 0;                    ///< among its kind
    std::vector<double> SunOfPlace::*hours;   ///< of sun a day
    double possibleHours = SunOfPlace::none;  ///< a day with the sun up; NaN: its days are not known
};
/// Seasons, months, dates.
std::vector<SunPart> listParts(const SunByPlace& sun);

/// Hours of sun stated as minutes of shadow, which are the rest of the sunlit time.
struct ShadowFigure {
    double SunOfPlace::*hours;
    std::string_view sunKey;             ///< of sunOfPlaceFigures()
    std::string key;                     ///< "shadow_mean_min"
    std::string_view label, definition;  ///< NM_TEXT
};
std::span<const ShadowFigure> shadowOfPlaceFigures();
/// The minutes of shadow that stand for a figure in hours of sun, with trees or without; null: it is in none.
const ShadowFigure* findShadow(const Figure& figure);
double shadowMinOf(double sunHours, double possibleHours);

/// A row for each place: name, kind, the figures, a column for each season, month and date, the same as
/// minutes of shadow, for each compared city its figures and changes in columns that end in its name
/// ("hours_mean_tower"), lon_deg and lat_deg of its middle, source. As CSV by toCsv(), as polygons by
/// writePlacesGeoPackage().
ElementTable makeTable(const SunByPlace& sun, std::span<const ComparedSun> compared = {});

/// How maps and styles colour places.
struct PlaceColours {
    LegendChoice legend{.show = ShownAs::sun};
    std::optional<double> thresholdHours{};  ///< none: the hours that are enough
    std::optional<std::size_t> date{};       ///< by the hours of this of its dates; none: of the period
    /// The column that the answer states (inColumn()), which legends name; none: it was measured in one only.
    std::optional<TreeColumns> column{};
};
/// An answer in the column that a legend shows, and the colours that name it: the answer itself where it has
/// no such column.
struct SunShown {
    std::shared_ptr<const SunOfCities> sun;
    PlaceColours colours;
};
SunShown showColumn(const std::shared_ptr<const SunOfCities>& all, PlaceColours colours);
/// Hours of sun a day of a place, of the period or of a date; NaN: none is known.
double hoursOf(const SunOfPlace& of, std::optional<std::size_t> date);
/// What places are coloured by: hours of sun, or minutes of shadow where the legend shows shadow and the
/// days are known.
struct ShownSunOrShadow {
    bool isShadow = false;
    double possibleHours = SunOfPlace::none;
    [[nodiscard]] double of(double sunHours) const;  ///< in the unit shown
};
ShownSunOrShadow chooseShown(const SunByPlace& sun, const PlaceColours& colours);
/// The scale of what is shown of the places, in the colours of the window.
ColourScale makeScale(const SunByPlace& sun, const PlaceColours& colours = {});

/// The columns of that table with the hours, the minutes of shadow and the change of hours of a month
/// ("2026-01"), a season or a date.
std::string hoursColumn(std::string_view of);
std::string shadowColumn(std::string_view of);
std::string changeColumn(std::string_view of);

/// The style of the places for QGIS: coloured by hours_mean or shadow_mean_min in the classes of their scale;
/// places without figures are not drawn. Others, to choose from: by each date, season and month.
LayerStyle makeStyle(const SunByPlace& sun, const PlaceColours& colours = {});

/// The command line that repeats it; see core/study/provenance/repeat_command.h. Error also where it is not
/// known how the places were chosen.
Result<std::string> makeRepeatCommand(const SunByPlace& sun, std::span<const ComparedSun> compared = {},
                                      std::size_t width = 120);

/// "0.022 % mean, 0.10 % largest, against rays"; "not measured".
std::string describeCellError(const std::optional<SampledError>& error);

/// Settings, figures, changes, error, times and what it was made from.
std::string toJson(const SunByPlace& sun, std::span<const ComparedSun> compared = {});

}  // namespace noonmark
