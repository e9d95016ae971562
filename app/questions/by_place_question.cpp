#include "app/input/all_engines.h"
#include "app/questions/saved_question.h"
#include "app/report/book/answer_books.h"
#include "app/report/book/print_book.h"
#include "app/report/files/answer_files.h"
#include "app/report/files/output_folder.h"
#include "app/report/files/saved_files.h"
#include "core/base/progress.h"
#include "core/describe/field_values.h"
#include "core/describe/text.h"
#include "core/study/by_place/place_tables.h"
#include "core/study/elements/element_tables.h"
#include "core/study/provenance/provenance_texts.h"
#include "scenarios/project/results/save_result.h"

namespace noonmark {

namespace {

// The hours that are enough can be changed in the answer, so they do not tell questions apart.
std::string questionOf(const SunOfCities& sun) {
    SunByPlaceSettings settings = sun.baseline.settings;
    settings.enoughHours = SunByPlaceSettings().enoughHours;
    return questionText(sunByPlaceFields().of(settings), true);
}

/// How much sun places get in one scenario, and what it takes from or gives to those of a baseline.
class ByPlaceAnswer final : public AnswerOf<SunOfCities> {
public:
    ByPlaceAnswer(std::shared_ptr<const SunOfCities> sun, StudySettings asked,
                  std::vector<ContributionTable> ofPlaces = {})
        : AnswerOf(std::move(sun)), asked_(std::move(asked)), ofPlaces_(std::move(ofPlaces)) {}

    [[nodiscard]] const Question& question() const override { return byPlaceQuestion(); }
    /// As they were asked for: the content's have the places as their region.
    [[nodiscard]] const StudySettings* settings() const override { return &asked_; }
    [[nodiscard]] MeasuredPart part() const override {
        const SunOfCities& sun = content();
        return {shownCity(sun).name, sun.compared.empty() ? std::string() : sun.baseline.name, {}, {}};
    }
    [[nodiscard]] const Warnings& warnings() const override { return content().baseline.warnings; }
    [[nodiscard]] double seconds() const override { return content().baseline.seconds.at("total"); }

    [[nodiscard]] bool asksSameAs(const Answer& other) const override {
        const auto* sun = other.as<SunOfCities>();
        return sun && Answer::asksSameAs(other) && sun->baseline.places == content().baseline.places &&
               questionOf(*sun) == questionOf(content());
    }

    /// The baseline of a comparison keeps its name: another one may be chosen while this answer is shown.
    [[nodiscard]] std::shared_ptr<const Answer> updated(const Project&, const std::string& scenario,
                                                        const std::string&) const override {
        if (shownCity(content()).name == scenario) return nullptr;
        auto sun = std::make_shared<SunOfCities>(content());
        (sun->compared.empty() ? sun->baseline : sun->compared.back().sun).name = scenario;
        return std::make_shared<ByPlaceAnswer>(std::move(sun), asked_, ofPlaces_);
    }
    [[nodiscard]] std::shared_ptr<const Answer> stated(Provenance provenance) const override {
        auto sun = std::make_shared<SunOfCities>(content());
        sun->baseline.provenance = std::move(provenance);
        return std::make_shared<ByPlaceAnswer>(std::move(sun), asked_, ofPlaces_);
    }
    [[nodiscard]] const std::vector<ContributionTable>& ofPlaces() const override { return ofPlaces_; }
    [[nodiscard]] std::shared_ptr<const Answer> withPlace(ContributionTable of) const override {
        return std::make_shared<ByPlaceAnswer>(shared(), asked_, withContributions(ofPlaces_, std::move(of)));
    }

    [[nodiscard]] std::shared_ptr<const Answer> withEnough(double hours) const override {
        if (hours == content().baseline.settings.enoughHours) return nullptr;
        auto sun = noonmark::withEnough(content(), hours);
        if (!sun) return nullptr;
        return std::make_shared<ByPlaceAnswer>(std::make_shared<const SunOfCities>(*std::move(sun)), asked_,
                                               ofPlaces_);
    }

    [[nodiscard]] AnswerPage page(const LegendChoice& shown) const override {
        return makePage(content(), shown.show);
    }
    [[nodiscard]] Result<std::string> command() const override {
        return makeRepeatCommand(content().baseline, content().compared);
    }
    [[nodiscard]] std::vector<CommandOption> drawnOptions(const AnswerFiles& how) const override {
        return listColourOptions({how.legend, how.thresholdHours});
    }

    [[nodiscard]] std::string json() const override {
        return withContributions(toJson(content().baseline, content().compared), ofPlaces_);
    }
    [[nodiscard]] SavedResult toSave(const Project& project) const override {
        SavedResult result = makeSavedResult(project, content());
        result.settings = withContributions(std::move(result.settings), ofPlaces_);
        return result;
    }
    [[nodiscard]] std::vector<std::string> fileNames(const AnswerFiles& how) const override {
        std::vector<std::string> names = byPlaceFileNames(how.sheets, content().baseline.settings.dates);
        std::ranges::move(placeContributionNames(ofPlaces_), std::back_inserter(names));
        return names;
    }
    [[nodiscard]] Result<std::vector<std::filesystem::path>> write(const City&,
                                                                   const std::filesystem::path& folder,
                                                                   const AnswerFiles& how) const override {
        const SunByPlace& sun = content().baseline;
        const SunShown shown = showColumn(shared(), {how.legend, how.thresholdHours});
        const PlaceColours& colours = shown.colours;
        const ElementTable table = makeTable(sun, content().compared);
        OutputFolder files(folder, how.rules);
        for (const PlaceTable& one : placeTables())
            files.add(one.file, textContent(toCsv(one.make(sun, content().compared))));
        files.add("places.gpkg", [&](const std::filesystem::path& file) {
            return writePlacesGeoPackage(file, sun.city.frame, sun.places, table,
                                         makeStyle(shown.sun->baseline, colours));
        });
        files.add("places.json", textContent(extendRepeat(json(), listColourOptions(colours))));
        addPlaceMaps(files, shared(), shown, shownCity(content()).city,
                     {colours, how.pictureWidth, sun.settings.study.receivers.cellM,
                      makeProvenanceTags(sun.provenance)});
        addPlaceContributions(files, ofPlaces_, shownCity(content()).city, sun.provenance);
        if (how.sheets) {
            const auto pdf = printBook(makeSunByPlaceBook(content(), bookOf(how), colours, shown.sun.get()));
            if (!pdf) return tl::make_unexpected(pdf.error());
            files.add("sheets.pdf", textContent(pdf->toStdString()));
        }
        return std::move(files).result();
    }
    [[nodiscard]] Result<std::shared_ptr<const Book>> layOut(const std::shared_ptr<const City>&,
                                                             const AnswerFiles& how) const override {
        const SunShown shown = showColumn(shared(), {how.legend, how.thresholdHours});
        return bundleBook(makeSunByPlaceBook(content(), bookOf(how), shown.colours, shown.sun.get()),
                          shared(), shown.sun);
    }

private:
    StudySettings asked_;
    std::vector<ContributionTable> ofPlaces_;
};

// The scenario comes last; without a baseline it is what the others are compared with.
std::vector<NamedCity> listCities(const Asked& asked) {
    std::vector<NamedCity> cities = asked.others;
    const NamedCity scenario{asked.scenario, asked.loaded.read.city};
    if (asked.before) {
        cities.insert(cities.begin(), {asked.baseline, *asked.before});
        cities.push_back(scenario);
    } else {
        cities.insert(cities.begin(), scenario);
    }
    return cities;
}

Result<std::shared_ptr<const Answer>> computeByPlace(const Asked& asked, Progress& progress,
                                                     const std::stop_token& stop) {
    ProgressShare whole(progress, 0, 1);  // forwards no partial results: they would cover one month only
    SunByPlaceSettings settings = asked.byPlace;
    settings.study = asked.settings;
    auto sun = compareSunByPlace(listCities(asked), asked.places, settings, whole, stop,
                                 enginesWith(asked.settings.engine), asked.forecast);
    if (!sun) return tl::make_unexpected(sun.error());
    if (asked.loaded.seconds > 0) sun->baseline.seconds["read"] = asked.loaded.seconds;
    prependWarnings(sun->baseline.warnings, asked.loaded.read.warnings);
    sun->baseline.provenance = asked.provenance;
    sun->baseline.asked = asked.placesAsked;
    return makeByPlaceAnswer(*std::move(sun), asked.settings);
}

std::shared_ptr<const Book> bookOfSavedPlaces(const SavedContent& saved, const SavedSource& source,
                                              const AnswerFiles& how) {
    SunOfCities sun = saved.as<SavedSunByPlace>()->sun;
    sun.baseline.city = source.city;
    for (ComparedSun& one : sun.compared) one.sun.city = source.city;
    const auto shared = std::make_shared<const SunOfCities>(std::move(sun));
    const SunShown shown = showColumn(shared, {how.legend, how.thresholdHours});
    return bundleBook(makeSavedBook(*saved.result, saved.answer.origin, source, *shared, bookOf(how),
                                    shown.colours, shown.sun.get()),
                      shared, shown.sun);
}

SavedForm savedPlaces() {
    return {[](const SavedContent& saved) {
                return savedPlaceNames(saved.as<SavedSunByPlace>()->sun.baseline.settings.dates);
            },
            [](const SavedContent& saved, const LegendChoice& shown) {
                return makePage(saved.as<SavedSunByPlace>()->sun, shown.show);
            },
            [](const SavedContent& saved, const SavedSource& source, const std::filesystem::path& folder,
               const AnswerFiles& how, const std::optional<std::string>& sheets) {
                return writeSavedPlaces(*saved.result, saved.as<SavedSunByPlace>()->sun,
                                        saved.answer.ofPlaces, source.city, folder,
                                        {.legend = how.legend, .rules = how.rules, .sheets = sheets});
            },
            bookOfSavedPlaces};
}

}  // namespace

std::shared_ptr<const Answer> makeByPlaceAnswer(SunOfCities sun, StudySettings asked) {
    return std::make_shared<ByPlaceAnswer>(std::make_shared<const SunOfCities>(std::move(sun)),
                                           std::move(asked));
}

std::vector<std::string> byPlaceFileNames(bool withSheets, std::span<const CivilDate> dates) {
    std::vector<std::string> names{"places.gpkg", "places.json"};
    for (const PlaceTable& table : placeTables()) names.emplace_back(table.file);
    std::ranges::move(placeMapNames(dates), std::back_inserter(names));
    if (withSheets) names.emplace_back("sheets.pdf");
    return names;
}

const Question& byPlaceQuestion() {
    static const Question question{.key = "by-place",
                                   .label = NM_TEXT("Sun by place"),
                                   .ofRun = false,
                                   .compute = computeByPlace,
                                   .saved = savedPlaces(),
                                   .filed = FiledForm{"by-place", "places.json"}};
    return question;
}

}  // namespace noonmark
