#pragma once

#include <QWidget>
#include <optional>
#include <string>

#include "app/gui/tools/massing/massing_form.h"
#include "scenarios/impact/proposal_region.h"
#include "scenarios/massing/fit_floor_area.h"

class QComboBox;
class QDoubleSpinBox;
class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QScrollArea;

namespace noonmark {

/// A floor area or a floor area ratio that the tower shall have. Typed, the tower takes it at once, by its
/// storeys or by its plate, as the buttons state; else the row has what the tower has.
class TargetRow final : public QWidget {
    Q_OBJECT
public:
    explicit TargetRow(QWidget* parent = nullptr);

    [[nodiscard]] FloorAreaTarget target() const;
    void showReached(double grossFloorM2, double ratio);  ///< what the tower has, without a signal

Q_SIGNALS:
    void fitRequested(noonmark::FloorAreaTarget target);

private:
    void choose(int kind);
    void fit(FloorAreaBy by);
    void fitTyped();
    void showNumber();

    QComboBox* kind_;
    QDoubleSpinBox* number_;
    FloorAreaBy by_ = FloorAreaBy::storeys;
    bool isFitting_ = false;
    double reachedM2_ = 0, reachedRatio_ = 0;
};

class MassingForm;

/// The dock for designing a tower on a lot: choice of lot, name, shape and resulting figures. Shows a draft
/// and emits its changes; figures or errors of the draft are passed in.
class MassingPanel final : public QWidget {
    Q_OBJECT
public:
    explicit MassingPanel(QWidget* parent = nullptr);

    void setLots(const std::vector<NamedLot>& lots);
    void showDraft(const TowerDraft& draft);  ///< without a signal
    void showNone();                          ///< no tower is being designed
    [[nodiscard]] std::optional<NamedLot> chosenLot() const;
    [[nodiscard]] TowerDraft draft() const;

    /// `groundElevationM`: of the ground under the tower, above the datum.
    void showFigures(const Massing& massing, std::size_t demolished, double groundElevationM);
    void setFacadesShown(bool shown);  ///< without a signal
    void setChangeShown(bool shown);   ///< likewise
    /// What the tower changes, in lines; empty: not known.
    void showEffect(const QString& words);
    void greyEffect();  ///< until showEffect(): the lines are of an earlier shape
    /// Where the tower stands as to the study's region: outside it, it says so and offers to move the region.
    void showInRegion(InRegion place);
    /// `nearest`: what would be possible, which a button takes, and whose field is marked; null: not known.
    void showError(const Error& error, const NearestFit* nearest = nullptr);
    /// A target that no settings reach; the tower stays as it is.
    void showNotReached(const Error& error);
    /// The lots with a tower that can be edited; those that are no lots of the project are listed after them.
    void setDesignedLots(std::vector<NamedLot> lots);
    void chooseLot(const std::string& name);  ///< the first where none is called so
    [[nodiscard]] QString message() const;    ///< the displayed error; empty: none

Q_SIGNALS:
    void drawRequested();
    void editRequested(noonmark::NamedLot lot);       ///< to change its outline
    void designRequested(noonmark::NamedLot lot);     ///< a tower on an existing lot
    void editTowerRequested(noonmark::NamedLot lot);  ///< the tower designed on this lot
    void copyRequested(noonmark::NamedLot lot);       ///< the tower selected or designed, on this lot
    void edited();
    void fitRequested(noonmark::FloorAreaTarget target);
    void nearestTaken();     ///< the nearest possible settings instead
    void regionRequested();  ///< of the study, around the tower
    void facadesShownChosen(bool shown);
    void changeShownChosen(bool shown);
    void applyRequested();
    void cancelled();

private:
    QWidget* makeLotRow();
    QWidget* makeLiveChoices();
    QWidget* makeFooter();
    QWidget* makeAnswerButtons();
    void enableLotButtons();
    void setDesigning(bool designing);

    void listLots();

    std::vector<NamedLot> projectLots_;
    std::vector<NamedLot> designed_;
    std::vector<NamedLot> lots_;  ///< as listed
    TowerDraft draft_;
    QComboBox* lot_;
    QPushButton* edit_;
    QPushButton* design_;
    QPushButton* editTower_;
    QPushButton* copy_;
    QScrollArea* scroll_;
    QWidget* body_;
    QWidget* footer_;
    QLabel* hint_;  ///< what to do where there are no lots
    QLabel* on_;
    QLineEdit* name_;
    TargetRow* target_;
    MassingForm* form_;
    QCheckBox* facades_;
    QCheckBox* change_;
    QLabel* figures_;
    QLabel* effect_;
    QLabel* beyond_;
    QPushButton* moveRegion_;
    QLabel* error_;
    QPushButton* nearest_;
    QPushButton* apply_;
};

}  // namespace noonmark
