#pragma once

// The study's form. StudyDock is the dock: WhatForm, WhenForm, WhereForm and AccuracySection, one for each
// question that a planner answers, and RunForecast, which states how long the study will take. PeriodPreset,
// periodOf and AccuracyChoice turn the plain choices into settings.

#include <QWidget>
#include <functional>

#include "app/gui/docks/study_form/what_form.h"
#include "app/gui/session/study/run_estimate.h"
#include "core/review/rule/rule.h"
#include "core/study/by_place/sun_by_place.h"
#include "core/study/study.h"

class QLabel;
class QPushButton;

namespace noonmark {

class AccuracySection;
class BreakdownForm;
class PlacesForm;
class ProgressStrip;
class RunForecast;
class StudyDocument;
class WhenForm;
class WhereForm;

/// The dock for the study: what, when, where, how exactly, and the run button. Shows and changes a
/// StudyDocument.
class StudyDock final : public QWidget {
    Q_OBJECT
public:
    explicit StudyDock(StudyDocument& document, QWidget* parent = nullptr);  ///< `document` must outlive it

    [[nodiscard]] ProgressStrip& progress() { return *progress_; }
    [[nodiscard]] const RunForecast& forecast() const { return *forecast_; }
    void setDrawing(bool drawing);  ///< while a region is being drawn
    void setRunning(bool running);
    /// The names of regions and places that can be chosen.
    void setRegions(const QStringList& names);
    void setEnough(double hours);              ///< of sun: the threshold of the answer that is shown
    void setScenarioCount(std::size_t count);  ///< of the project, with the existing city
    void setPlaces(const std::vector<Place>& places, const std::vector<Region>& regions);  ///< of the project
    void setCity(std::shared_ptr<const City> city);  ///< of the displayed scenario
    void setRules(const std::vector<Rule>& rules);   ///< whose days and hours are offered
    void setBuilding(const QString& id);             ///< the selected building; empty: none
    /// Looks up the parts of the settings in the project (findElementParts()), to estimate the time of a run.
    using ElementFinder = std::function<ElementSettings(const ElementSettings&)>;
    void setElementFinder(ElementFinder find);
    /// Lists the cities whose places are to be measured, the baseline first, likewise.
    using CityFinder = std::function<std::vector<std::shared_ptr<const City>>(bool allScenarios)>;
    void setCityFinder(CityFinder find);
    [[nodiscard]] ElementForm& elements() { return what_->elements(); }
    [[nodiscard]] PlacesForm& places() { return *places_; }
    void setComparing(bool comparing);  ///< run() compares the scenario with a baseline
    /// The kind of study that is chosen.
    [[nodiscard]] StudyKind kind() const { return what_->kind(); }
    void restore(StudyKind kind);  ///< as it was saved: its period is the document's
    /// Another project, which asks nothing yet: the kind of study stays, with the days that it begins with.
    void beginAnew();
    void choose(StudyKind kind);  ///< as the user does in the list
    void run();                   ///< as the button does
    /// Asks for the sun of the chosen places in all scenarios.
    void runByPlaceInAll();
    /// Wide enough for the forms without scrolling sideways.
    [[nodiscard]] QSize sizeHint() const override;

Q_SIGNALS:
    void runRequested();
    void sunByPlaceRequested(std::vector<noonmark::Place> places, noonmark::SunByPlaceSettings settings,
                             bool allScenarios);
    void streetsRequested();  ///< to be read into the project
    void drawRequested(bool draw);
    void viewRegionRequested();
    void wholeCityRequested();
    void surroundingsRequested();           ///< of the selected building, as the region
    void regionNamed(const QString& name);  ///< of the list, or typed
    void kindChosen(noonmark::StudyKind kind);
    void scoreRequested();  ///< with the weights of their panel
    void paperRequested();

private:
    void placeForms();
    void connectForms();
    void connectRegion();
    void runByPlace();
    void takeKind(StudyKind kind);
    void usePeriodOf(StudyKind kind);
    void showDocument();
    void showKind();
    void askForecast();
    [[nodiscard]] bool hasQuestion() const;
    void showForecast();
    void showRefusal();
    [[nodiscard]] std::optional<ElementSettings> measuredElements() const;
    [[nodiscard]] QString runText() const;
    [[nodiscard]] QString whyNotCells() const;
    [[nodiscard]] QString whyNotPoints() const;

    StudyDocument& document_;
    WhatForm* what_;
    BreakdownForm* breakdown_;
    WhenForm* when_;
    WhereForm* where_;
    PlacesForm* places_;                  ///< instead of it, for the sun by place
    std::optional<Period> periodBefore_;  ///< that the whole year took the place of
    AccuracySection* accuracy_;
    RunForecast* forecast_;
    QLabel* forecastLine_;
    QLabel* refusal_;  ///< why the engine cannot run this study
    bool terrain_ = false;
    bool comparing_ = false;
    bool running_ = false;
    bool changedSinceRun_ = false;
    bool hasCity_ = false;
    QPushButton* run_;
    ProgressStrip* progress_;
    ElementFinder find_;
    CityFinder findCities_;
    int formsWidth_ = 0;  // px, all they need
};

}  // namespace noonmark
