#pragma once

#include <QPointer>
#include <QWidget>

#include "scenarios/massing/fit_floor_area.h"

class QDoubleSpinBox;
class QGroupBox;
class QLabel;
class QSpinBox;

namespace noonmark {

class FurtherTable;
class LengthField;
class PlateField;
class SetbackTable;
class UseTable;
class WallField;

/// Fields for the MassingSettings of one tower. Number of storeys and total height are two fields for one
/// quantity: changing one updates the other.
class MassingForm final : public QWidget {
    Q_OBJECT
public:
    explicit MassingForm(QWidget* parent = nullptr);

    [[nodiscard]] const MassingSettings& settings() const { return settings_; }
    void show(const MassingSettings& settings);  ///< without a signal
    /// The ground under the tower, metres above the datum: heights are shown from there or from the datum.
    void setGround(double groundElevationM);
    /// Marks the field of the number that makes the tower impossible; null: none.
    void markWrong(const NearestFit* fit);

Q_SIGNALS:
    void edited();

private:
    void makeFields();
    void connectFields();
    void takeHeight();
    void takeRest();
    void addSetback();
    void addTower();
    [[nodiscard]] QWidget* fieldOf(const NearestFit& fit) const;

    MassingSettings settings_;
    QSpinBox* storeys_;
    QDoubleSpinBox* storeyHeight_;
    LengthField* height_;
    QLabel* heightLabel_;
    PlateField* plate_;
    QDoubleSpinBox* turn_;
    WallField* walls_;
    QGroupBox* podium_;
    QSpinBox* podiumStoreys_;
    PlateField* podiumPlate_;
    WallField* podiumWalls_;
    SetbackTable* setbacks_;
    UseTable* uses_;
    FurtherTable* further_;
    LengthField* gap_;
    QPointer<QWidget> wrong_;  ///< the marked field
    bool showing_ = false;
};

}  // namespace noonmark
