#pragma once

#include <QWidget>
#include <set>

#include "core/study/by_place/sun_by_place.h"
#include "core/study/study.h"

class QComboBox;
class QLabel;
class QPushButton;
class QCheckBox;
class QDoubleSpinBox;
class QLineEdit;
class QListWidget;

namespace noonmark {

/// Where: a region or place by name, a drawn region, the view, the whole city or a building's surroundings.
class WhereForm final : public QWidget {
    Q_OBJECT
public:
    explicit WhereForm(QWidget* parent = nullptr);

    void show(const StudySettings& settings);  ///< without a signal
    void setDrawing(bool drawing);             ///< while a region is being drawn
    void setNames(const QStringList& names);   ///< of regions and places that can be chosen
    void setBuilding(bool selected);           ///< a building is selected

Q_SIGNALS:
    void drawRequested(bool draw);
    void viewRequested();
    void wholeCityRequested();
    void surroundingsRequested();     ///< of the selected building
    void named(const QString& name);  ///< of the list, or typed

private:
    void makeList();
    QWidget* makeButtons();
    void showName();

    QComboBox* names_;
    QPushButton* draw_;
    QPushButton* surroundings_;
    QLabel* region_;
    QString name_;
};

/// Which places sun is measured on: the project's by kind, how much sun is enough, and the dates on which
/// less is stated.
class PlacesForm final : public QWidget {
    Q_OBJECT
public:
    explicit PlacesForm(QWidget* parent = nullptr);

    /// The places and regions of the project; ticks stay. Regions count as places once they are ticked.
    void setPlaces(const std::vector<Place>& places, const std::vector<Region>& regions);
    /// The dates follow the year of the period until others are typed.
    void setYear(std::chrono::year year);
    void setComparing(bool comparing);  ///< a baseline is chosen
    void setEnough(double hours);       ///< of the answer that is shown: the next run begins with it
    void setScenarioCount(std::size_t scenarios);  ///< of the project, with the existing city
    /// The places are measured in all scenarios, not only in the displayed one and its baseline.
    [[nodiscard]] bool allScenarios() const;
    [[nodiscard]] std::size_t cityCount() const;  ///< in which they are measured
    [[nodiscard]] std::vector<Place> chosen() const;
    /// Without a study. Error: a date that is none.
    [[nodiscard]] Result<SunByPlaceSettings> settings() const;

Q_SIGNALS:
    void edited();
    void streetsRequested();  ///< to be read into the project, which has none

private:
    void fill();
    void addLine(const QString& text, int kind, bool ticked);
    void enable();
    void follow();

    std::vector<Place> places_;
    std::vector<Region> regions_;
    std::set<PlaceKind> unticked_{PlaceKind::facade, PlaceKind::stainedGlass};
    bool regionsTicked_ = false;
    std::chrono::year year_{2026};
    QListWidget* kinds_;
    QLabel* none_;  ///< where the project has no places
    QPushButton* streets_;
    QDoubleSpinBox* enough_;
    QLineEdit* dates_;
    QCheckBox* all_;
    bool comparing_ = false;
    std::size_t scenarios_ = 1;
    QLabel* refusal_;  ///< what is wrong with the dates
};

}  // namespace noonmark
