#pragma once

#include <QWidget>

#include "core/study/study.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace noonmark {

class AccuracyForm;
class PeriodForm;
class ProgressStrip;
class StudyDocument;

/// The dock for the study's settings: period, region, cells, engine, and the run button. Shows and changes a
/// StudyDocument.
class StudyDock final : public QWidget {
    Q_OBJECT
public:
    explicit StudyDock(StudyDocument& document, QWidget* parent = nullptr);  ///< `document` must outlive it

    [[nodiscard]] ProgressStrip& progress() { return *progress_; }
    void setDrawing(bool drawing);  ///< while a region is being drawn
    void setRunning(bool running);
    /// The names of regions and places that can be chosen.
    void setRegions(const QStringList& names);
    void setTerrain(bool terrain);  ///< the city has terrain, which not every engine supports

Q_SIGNALS:
    void runRequested();
    void drawRequested(bool draw);
    void viewRegionRequested();
    void wholeCityRequested();
    void regionNamed(const QString& name);  ///< of the list, or typed

private:
    QWidget* makeRegionGroup();
    QWidget* makeRegionList();
    QWidget* makePlaces();
    void showRegionName();
    void showDocument();
    void showRefusal();

    StudyDocument& document_;
    PeriodForm* period_;
    AccuracyForm* accuracy_;
    QLabel* region_;
    QComboBox* regions_;
    QComboBox* places_;
    QLabel* refusal_;  ///< why the engine cannot run this study
    bool terrain_ = false;
    QPushButton* draw_;
    QPushButton* run_;
    ProgressStrip* progress_;
};

}  // namespace noonmark
