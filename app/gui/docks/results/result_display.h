#pragma once

// What the window shows of results. ResultDisplay fills the docks and the ResultLayer of the view,
// ResultsDock shows the figures, month_chart those of a score's months.

#include <QObject>

#include "app/gui/base/layers/element_picture.h"
#include "app/gui/session/workbench.h"

namespace noonmark {

class EditPreview;
class ElementsDock;
class ModeSwitch;
class ResultLayer;
class ResultsDock;
class ScenarioTable;
class WarningsDock;

/// Shows the workbench's result: as colours in the view, as figures and warnings in the docks. A saved result
/// comes before a score or a study at points, these before a comparison, a comparison before a study. A
/// result for buildings that have changed stays, marked as outdated.
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
    };
    ResultDisplay(Workbench& workbench, ModeSwitch& mode, const EditPreview& preview, const Places& places);

    void showCity();                    ///< another city, with its warnings and its result, if there is one
    void forget();                      ///< another project: nothing of it has been shown
    void setHint(const QString& hint);  ///< shown while there are no figures

    /// A study or comparison of this project has been shown.
    [[nodiscard]] bool anyShown() const { return anyShown_; }
    /// Settings of the result shown last.
    [[nodiscard]] const StudySettings& settings() const { return settings_; }

Q_SIGNALS:
    void updated();        ///< the result, or what is stated about it
    void elementsShown();  ///< a study at points: its table should be visible
    void chosen();         ///< a score or saved result that the user asked for: its figures should be visible

private:
    void compare();
    void showResult();
    void showStudy();
    void showPast();
    void showComparison();
    void showScore();
    void showElements();
    void showPoints(const std::shared_ptr<const ElementAnswer>& answer, ElementView view);
    void showSaved();
    void hideOthers();
    void update();
    void showOutdated();
    [[nodiscard]] QString whyOutdated() const;

    Workbench& workbench_;
    ModeSwitch& mode_;
    const EditPreview& preview_;
    Places places_;
    bool anyShown_ = false;
    StudySettings settings_;
    std::optional<ElementSettings> elements_;  ///< of the result shown last, if of points
};

}  // namespace noonmark
