#pragma once

#include <QObject>
#include <QWidget>
#include <optional>

#include "app/gui/tools/preview/edit_context.h"
#include "core/io/read_city.h"
#include "scenarios/edits/edit.h"
#include "scenarios/edits/read_shape.h"

class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace noonmark {

class FieldRows;

/// Reading settings, scale and rotation of a mesh being placed. The place itself is clicked in the view.
class PlacingPanel final : public QWidget {
    Q_OBJECT
public:
    explicit PlacingPanel(QWidget* parent = nullptr);

    void begin(const QString& file);
    /// Axes and unit that the file states cannot be chosen.
    void setStated(bool axes, bool unit);
    /// The mesh has a place, so it can be built. `groundElevationM`: of the ground under it, above the datum.
    void showPlaced(double heightM, double groundElevationM);
    void showMiddle(LonLat middle);  ///< its place, without placeTyped()
    /// Scale, rotation and storeys of an earlier edition, or those that the file states, without edited().
    void preset(double scale, double clockwiseDeg, double storeyHeightM);
    /// An earlier edition of the file can be replaced; empty: there is none.
    void setEarlier(const QString& building);
    void showWarnings(const Warnings& warnings);     ///< of reading the file
    void showReading(const ReadSettings& settings);  ///< axes and unit, without readingEdited()
    /// The settings with the axes and the unit chosen here.
    [[nodiscard]] ReadSettings reading(ReadSettings settings) const;
    [[nodiscard]] double scale() const;
    [[nodiscard]] double clockwiseDeg() const;
    [[nodiscard]] double storeyHeightM() const;  ///< 0: not known

Q_SIGNALS:
    void edited();
    void placeTyped(noonmark::LonLat middle);
    void readingEdited();
    void applyRequested();
    void reloadRequested();
    void cancelled();

private:
    QLabel* what_;
    QLabel* warnings_;
    FieldRows* axes_;
    QDoubleSpinBox* scale_;
    QDoubleSpinBox* turn_;
    QDoubleSpinBox* storeyHeight_;
    QDoubleSpinBox *longitude_, *latitude_;
    QPushButton *apply_, *reload_;
    QString file_;
};

/// Adds a mesh file as a building: the file is read, placed by clicks, and scaled and rotated in the panel.
class MeshPlacing final : public QObject {
    Q_OBJECT
public:
    MeshPlacing(EditContext& context, PlacingPanel& panel, QObject* parent = nullptr);  ///< both outlive it

    /// `place`: its middle on the ground; empty: the user clicks it.
    void begin(const QString& file, std::optional<glm::dvec2> place = {});
    void show();  ///< again, in the current city
    void cancel();
    [[nodiscard]] bool active() const { return mesh_.has_value(); }
    void placeAt(glm::dvec2 ground);
    void build();  ///< does nothing before the mesh is placed
    /// The file takes the place of its earlier edition; the edits that follow it stay.
    void reload();
    [[nodiscard]] std::optional<double> storeyHeightM() const;  ///< as entered; nothing: not known

Q_SIGNALS:
    void began();
    void editsMade(std::vector<noonmark::Edit> edits, QString what, std::string building);
    void editionRead(noonmark::ImportMesh edition);
    void ended();
    void failed(noonmark::Error error);

private:
    struct Read {
        ImportMesh mesh;
        Warnings warnings;
        OwnPlace own;
    };
    void preset(const OwnPlace& own);
    [[nodiscard]] const ImportMesh* findEarlier() const;  ///< edition of the file; null: none
    void read();
    void take(Result<Read> read);

    EditContext& context_;
    PlacingPanel& panel_;
    QString file_;
    std::optional<ImportMesh> mesh_;
    std::optional<glm::dvec2> place_;
    ReadSettings reading_;  // of the earlier edition
    JobSlot job_;
};

}  // namespace noonmark
