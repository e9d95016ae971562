#pragma once

#include <QWidget>
#include <chrono>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "core/study/by_place/sun_by_place.h"

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace noonmark {

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
    [[nodiscard]] std::vector<Place> chosen() const;
    /// Without a study. Error: a date that is none.
    [[nodiscard]] Result<SunByPlaceSettings> settings() const;

    /// What is ticked and typed, as JSON, which is saved with the view of the project.
    [[nodiscard]] std::string choice() const;
    /// Reads what is valid; the rest is as at first. Accepts any text.
    void restore(const std::string& choice);

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
    static inline const std::set<PlaceKind> untickedAtFirst{PlaceKind::facade, PlaceKind::stainedGlass};
    std::set<PlaceKind> unticked_ = untickedAtFirst;
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
