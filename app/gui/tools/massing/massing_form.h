#pragma once

#include <QPointer>
#include <QWidget>
#include <string>
#include <vector>

#include "core/city/city.h"
#include "scenarios/edits/edit.h"
#include "scenarios/massing/fit_floor_area.h"
#include "scenarios/massing/massing.h"
#include "scenarios/project/project.h"

class QDoubleSpinBox;
class QGroupBox;
class QLabel;
class QSpinBox;

namespace noonmark {

/// A tower on a lot that is not built yet, as entered in the form.
struct TowerDraft {
    NamedLot lot;
    MassingSettings settings;
    std::string tower;     ///< id and name of the new building, not empty
    std::string replaces;  ///< id of the building that it replaces; empty: none
    bool operator==(const TowerDraft&) const = default;
};

/// The tower, and the edits that build it: the buildings on the lot are demolished; the tower replaces the
/// building it is meant for, or is added. Error: an invalid massing, with the limit. Takes about 5 ms.
struct DraftedTower {
    Massing massing;
    std::vector<Edit> edits;
};
Result<DraftedTower> draftTower(const City& city, const TowerDraft& draft);

/// "Tower 1", or with the first number that is not a building's id.
std::string freeTowerName(const City& city);
/// "Lot 1", or with the first number that is not used.
std::string freeLotName(const std::vector<NamedLot>& lots);

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
    void placePodium();
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
