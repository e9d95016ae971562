#pragma once

#include <QWidget>
#include <memory>

#include "app/gui/base/layers/field_picture.h"
#include "app/gui/docks/places/place_sun_model.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSlider;
class QTimer;
class QTreeView;

namespace noonmark {

/// How much sun places get: a table that sorts, filters and points at the view, and a threshold that colours
/// table and view and counts the places below it.
/// places_listing.cpp: what is listed and counted, places_in_view.cpp: what the view shows of it.
class PlacesDock final : public QWidget {
    Q_OBJECT
public:
    static constexpr double maxThreshold = 12, maxShade = 24;  ///< hours of sun, of shade a day

    explicit PlacesDock(QWidget* parent = nullptr);

    /// Null: none. `note`: stands beside the legend instead of the error; `outdated`: as a warning.
    void show(std::shared_ptr<const SunOfCities> sun, const QString& note, bool outdated);
    /// Not empty: the view shows something else than this answer, whose name it is; its threshold stays as
    /// the answer states it.
    void setAside(const QString& name);
    void setColours(const LegendChoice& choice);  ///< those that the user chose for legends
    void setShown(ShownAs show);                  ///< hours of sun, or minutes of shadow
    void select(std::size_t place);               ///< without wanted(); a filter that hides it is emptied
    /// What is listed and how, as JSON, which is saved with the view of the project.
    [[nodiscard]] std::string choice() const;
    /// Of the answer that is shown next. Reads what is valid. Accepts any text.
    void restore(const std::string& choice);
    /// What the view shows of it; null: nothing.
    [[nodiscard]] std::shared_ptr<const PlaceView> view() const { return view_; }
    [[nodiscard]] std::optional<std::size_t> placeAt(glm::dvec2 point) const {
        return picture_.placeAt(point);
    }
    [[nodiscard]] const PlaceSunModel& model() const { return *model_; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

Q_SIGNALS:
    /// Double click, or the button below the table: what buildings take from the place is to be shown.
    void dateChosen(std::optional<std::size_t> date);  ///< of the answer's; none: the period, or the change
    void contributorsRequested(std::size_t place);
    void returnRequested();                 ///< the answer set aside is to be shown again
    void viewChanged();                     ///< view()
    void highlighted(std::size_t place);    ///< the current row
    void goToRequested(std::size_t place);  ///< a click on its row, or Enter
    void thresholdChosen(double hours);     ///< once it has come to rest: all of the answer is to follow it

private:
    void placeFields();
    QWidget* makeThreshold();
    QWidget* makeAside();
    QWidget* makeFilters();
    void makeTable();
    void connectFields();
    void connectTable();
    void fillTrees();
    void chooseTrees();
    [[nodiscard]] std::shared_ptr<const SunOfCities> inChosenColumn() const;
    void take(std::shared_ptr<const SunOfCities> sun, bool mayRestate);
    void fillLists();
    void applyRestored();
    void fitColumns();
    void fitNames();
    void showThreshold();
    void showWordsLast();
    void showNextToNames();
    void limitRows();
    void follow(double hours);
    void colour();
    void enableThreshold();
    void describeCount();
    [[nodiscard]] QString describeLimit(const QString& counts, const ShownSun& shown) const;
    [[nodiscard]] PlaceSunFilter::Limit limitOf(const ShownSun& shown) const;
    [[nodiscard]] bool offersShade(const ShownSun& shown) const;
    [[nodiscard]] bool asksForShade(const ShownSun& shown) const;
    [[nodiscard]] bool hasSun(std::optional<std::size_t> place) const;
    [[nodiscard]] bool isCounted(std::size_t place) const;  ///< of the kind that is listed
    void listed();
    [[nodiscard]] ShownSun shown() const;
    [[nodiscard]] ColourScale scaleOf(const ShownSun& shown) const;
    [[nodiscard]] ColourScale scaleAsShown(ColourScale scale, const ShownSun& shown) const;
    [[nodiscard]] Legend legendOf(const ColourScale& scale, const ShownSun& shown) const;
    [[nodiscard]] QString describeError(const ShownSun& shown) const;
    void emitDate();
    [[nodiscard]] std::string describeListing(std::optional<double> thresholdHours) const;
    [[nodiscard]] PlaceView makeView(const std::string& scenario) const;
    [[nodiscard]] QString describeAt(glm::dvec2 point, const ShownSun& shown,
                                     const std::string& scenario) const;

    QLabel* aside_;
    QPushButton* return_;
    PlaceSunModel* model_;
    PlaceSunFilter* filter_;
    QLabel* count_;
    QComboBox* shown_;
    QComboBox* trees_;  ///< which column is stated; hidden where there is one only
    QSlider* slider_;
    QDoubleSpinBox* threshold_;
    QDoubleSpinBox* shade_;  ///< less shade than this is counted; 0: less sun than threshold_
    QLineEdit* text_;
    QComboBox* kinds_;
    QCheckBox* grouped_;
    QCheckBox* onlyBelow_;
    QTreeView* table_;
    QLabel* listed_;
    QPushButton* contributors_;
    std::shared_ptr<const SunOfCities> answer_;  ///< of which the model has one column
    PlacePicture picture_;
    std::shared_ptr<const PlaceView> view_;
    QString note_;
    bool outdated_ = false;
    LegendChoice colours_;
    std::string restored_;                          ///< empty: nothing
    QTimer* rest_;                                  ///< of the threshold
    int namesPx_ = 0;                               ///< width of the widest name; 0: there is none
    int nextToNames_ = PlaceSunModel::firstFigure;  ///< the column that is shown there
};

}  // namespace noonmark
