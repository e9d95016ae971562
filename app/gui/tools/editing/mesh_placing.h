#pragma once

#include <QObject>
#include <optional>

#include "app/gui/tools/preview/edit_context.h"
#include "scenarios/edits/edit.h"

namespace noonmark {

class PlacingPanel;

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
    void build();                                               ///< does nothing before the mesh is placed
    [[nodiscard]] std::optional<double> storeyHeightM() const;  ///< as entered; nothing: not known

Q_SIGNALS:
    void began();
    void editsMade(std::vector<noonmark::Edit> edits, QString what, std::string building);
    void ended();
    void failed(noonmark::Error error);

private:
    struct Read {
        ImportMesh mesh;
        Warnings warnings;
    };
    void read();
    void take(Result<Read> read);

    EditContext& context_;
    PlacingPanel& panel_;
    QString file_;
    std::optional<ImportMesh> mesh_;
    std::optional<glm::dvec2> place_;
    JobSlot reading_;
};

}  // namespace noonmark
