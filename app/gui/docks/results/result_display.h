#pragma once

// What the window shows of results. ResultDisplay fills the docks and the ResultLayer of the view,
// ResultsDock is the sheet of an answer.

#include <QObject>

#include "app/gui/session/answers/answer_viewer.h"
#include "app/gui/session/workbench.h"

namespace noonmark {

class EditPreview;
class ElementsDock;
class LegendStrip;
class ModeSwitch;
class ResultLayer;
class ResultsDock;
class ScenarioTable;
class WarningsDock;

/// Shows the workbench's answer: as colours in the view, as figures and warnings in the docks. One about
/// buildings that have changed stays, marked as outdated.
class ResultDisplay final : public QObject {
    Q_OBJECT
public:
    /// What it shows results in. All must outlive the display.
    struct Places {
        ResultLayer& layer;
        ResultsDock& figures;
        ElementsDock& elements;
        WarningsDock& warnings;
        ScenarioTable& scenarios;
        LegendStrip& legend;
    };
    ResultDisplay(Workbench& workbench, ModeSwitch& mode, const EditPreview& preview, const Places& places);

    void showCity();                    ///< another city, with its warnings and its result, if there is one
    void forget();                      ///< another project: nothing of it has been shown
    void setHint(const QString& hint);  ///< shown while there are no figures
    void showPlace(std::size_t place);  ///< of an answer about places: its figures instead of those of all

    /// An answer of a run on this project has been shown.
    [[nodiscard]] bool anyShown() const { return anyShown_; }
    /// Settings of the answer shown last, saved results left aside.
    [[nodiscard]] const StudySettings& settings() const { return settings_; }

Q_SIGNALS:
    void updated();        ///< the answer, or what is stated about it
    void elementsShown();  ///< an answer of points: its table should be visible
    void contributorsRequested(const std::string& place);  ///< what buildings take from it is to be shown
    void chosen();  ///< an answer beside those of Run, asked for just now: its figures should be visible

private:
    void showAnswered();
    void show();
    void showPast();
    void showInView(const std::shared_ptr<const Answer>& answer);
    void showLayer(const std::optional<AnswerLayer>& layer, bool isStudy);
    void showFigures(const std::shared_ptr<const Answer>& answer);
    [[nodiscard]] LegendChoice choiceFor(const std::shared_ptr<const Answer>& answer) const;
    [[nodiscard]] static std::vector<TreeColumns> listColumns(const std::shared_ptr<const Answer>& answer);
    [[nodiscard]] std::vector<ResultRow> rowsOfPlace(const Answer& answer, const SunOfCities& sun) const;
    void showAllPlaces();
    void repeatFigures();
    void followLegend();
    void listAnswers();
    void showNamed(const std::string& name);
    void showListed(int answer);
    void update();
    void showOutdated();
    [[nodiscard]] QString whyOutdated() const;

    Workbench& workbench_;
    ModeSwitch& mode_;
    const EditPreview& preview_;
    Places places_;
    std::vector<std::function<void()>> listed_;  ///< shows the answers of the list, in its order
    bool anyShown_ = false;
    StudySettings settings_;
    LegendChoice shown_;                ///< whose quantity and trees the figures state
    std::optional<std::size_t> place_;  ///< of an answer about places: the one whose figures are shown
};

}  // namespace noonmark
