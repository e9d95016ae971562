#pragma once

#include <QObject>
#include <QString>
#include <QWidget>
#include <glm/vec2.hpp>
#include <optional>
#include <span>

#include "core/city/building_heights.h"
#include "core/city/city.h"
#include "scenarios/massing/tower_design.h"

class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace noonmark {

/// Facts about a building for the selection panel.
struct BuildingFacts {
    QString title;  ///< name, or id if it has none
    QString id;
    double heightM = 0;           ///< above the ground at the building
    double groundElevationM = 0;  ///< of that ground, above the datum
    double highestPartM = 0;      ///< above its own ground: less where that lies higher than that of others
    bool hasElevations = false;   ///< the files state elevations
    QString heightSource;
    double storeyHeightM = defaultStoreyM;  ///< of the design or of the data's storeys, else the usual one
    bool designed = false;                  ///< storeys and floor area are those of a design
    bool storeysAreStated = false;          ///< by the design or the data
    int storeys = 0;                        ///< 0: less than one
    std::size_t parts = 0;
    double planM2 = 0;  ///< area of the parts that touch the ground; of all where none has a storey there
    std::optional<double> grossFloorM2;  ///< of these storeys; none: no storey stands on the ground
    int estimatedStoreys = 0;  ///< storeys of that area that are estimated, because the mesh is open
};

/// Facts about several buildings.
struct GroupFacts {
    std::size_t buildings = 0;
    double grossFloorM2 = 0;     ///< together, at defaultStoreyM per storey
    std::size_t unmeasured = 0;  ///< buildings without a storey on the ground, which that sum lacks
};
GroupFacts collectFacts(std::span<const std::uint32_t> buildings, const City& city);

/// `tower`: what is known of it as a tower of the scenario; null: nothing. `levelM`: the storey by which
/// heights of storeys were read (ReadSettings::metresPerLevel). Takes some ms for a building of hundreds of
/// points.
BuildingFacts collectFacts(const Building& building, const City& city, const ProposedTower* tower = nullptr,
                           double levelM = defaultStoreyM);

/// The largest piece of the building's outline on the ground, as a lot. Nothing if no part touches the
/// ground.
std::optional<Footprint> lotUnder(const Building& building, const City& city);

class LengthField;

/// The dock of the selected building, or of several: facts and edits. A number being changed is previewed at
/// once; Enter makes the edit.
class SelectionPanel final : public QWidget {
    Q_OBJECT
public:
    explicit SelectionPanel(QWidget* parent = nullptr);

    void show(const std::optional<BuildingFacts>& facts);  ///< none: no selection
    void showGroup(const GroupFacts& facts);               ///< instead of one building
    /// While the handle is dragged; without a signal.
    void showHeight(double heightM);
    void showMove(glm::dvec2 byM);  ///< likewise
    void setMoving(bool moving);    ///< the move tool is active
    /// The building is a tower whose design is known: it is edited instead of replaced.
    void setDesigned(bool designed);
    /// What the edit being previewed changes, in lines; empty: not known, or no edit.
    void showEffect(const QString& words);
    void showError(const QString& text);  ///< empty: none
    [[nodiscard]] QString message() const;

Q_SIGNALS:
    void demolishRequested();  ///< of all that are selected
    void replaceRequested();
    void lotRequested();
    void moveToolRequested(bool on);
    void variantRequested(double plateFactor);
    void importRequested();

    void heightChanged(double heightM);
    void heightTaken(double heightM);
    void moveChanged(glm::dvec2 byM);
    void moveTaken(glm::dvec2 byM);
    void turnChanged(double clockwiseDeg);
    void turnTaken(double clockwiseDeg);

private:
    QWidget* makeFacts();
    QWidget* makeFields();
    QWidget* makeVariants();
    QWidget* makeButtons();
    void connectFields();
    void onEnter(const QDoubleSpinBox& field, void (SelectionPanel::*take)());
    void takeMove();
    void takeHeight();
    void takeTurn();
    [[nodiscard]] glm::dvec2 move() const;

    QLabel* facts_;
    QWidget* tools_;
    QPushButton* demolishAll_;
    LengthField* height_;
    QLabel* heightLabel_;
    QDoubleSpinBox* east_;
    QDoubleSpinBox* north_;
    QDoubleSpinBox* turn_;
    QPushButton* replace_;
    QPushButton* moveTool_;
    QLabel* effect_;
    QLabel* error_;
    double heightM_ = 0;  // of the building, or as entered last
    bool showing_ = false;
};

}  // namespace noonmark
