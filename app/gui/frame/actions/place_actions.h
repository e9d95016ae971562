#pragma once

#include <QObject>
#include <QPointF>
#include <QStringList>
#include <functional>
#include <optional>

#include "app/gui/base/jobs/job.h"
#include "app/gui/session/project/project_changes.h"
#include "core/io/places/read_places.h"

class QAction;
class QWidget;

namespace noonmark {

class EditTools;
class OpeningActions;
class ProjectDock;
class ViewPanel;
class Workbench;

/// Adds places to the project: read from files, drawn, or made of the selected building's outline; shows them
/// in the view and zooms to one. Each addition is one undo step.
class PlaceActions final : public QObject {
    Q_OBJECT
public:
    /// Dialogs belong to `window`. All must outlive this object.
    PlaceActions(Workbench& workbench, OpeningActions& opening, EditTools& tools, ViewPanel& panel,
                 ProjectDock& tree, QWidget& window);

    [[nodiscard]] QList<QAction*> actions() const { return {read_, streets_, draw_, fromBuilding_}; }
    [[nodiscard]] QAction* addAction() const { return add_; }            ///< files to the open city
    [[nodiscard]] QAction* showAction() const { return show_; }          ///< shows and hides names
    [[nodiscard]] QAction* outlinesAction() const { return outlines_; }  ///< shows outlines of all places

    /// What becomes of the project's places of the same source: read again, they are replaced.
    enum class EarlierPlaces { areReplaced, stay };
    /// Reads places into the open project. Of a single file with several layers that state no kinds of places
    /// one is asked for.
    void read(const QStringList& files, const PlaceSettings& settings = {},
              EarlierPlaces earlier = EarlierPlaces::areReplaced);
    /// Reads the streets of the city's files: of OpenStreetMap, or layers of lines; where it has none, of
    /// files that the user chooses.
    void readStreets();
    /// Files dropped on the window. A mesh dropped on an open city becomes a proposal, placed on the lot
    /// under `pixel` or there on the ground. Other files are opened, or, if a city is open and they may hold
    /// places, as the user chooses.
    void takeDropped(const QStringList& files, std::optional<QPointF> pixel = {});
    /// Adds terrain, an aerial photograph, trees or places to the open city; never replaces what it has.
    void addFiles(const QStringList& files);
    void draw() { draw(PlaceKind::park, {}); }
    /// What is drawn is of this kind; `named` takes its name, to be typed anew. Null: in the project tree.
    using DrawnPlace = std::function<void(const std::string& name)>;
    void draw(PlaceKind kind, DrawnPlace named);
    void makeFromBuilding();
    void zoomTo(const std::string& place);

    enum class Dropped { open, readPlaces, nothing };
    /// What a file that is added to the city may be.
    enum class Added { places, terrain, trees, nothing };
    /// Replaces the menu that asks what to do with dropped files.
    void setDropQuestion(std::function<Dropped()> ask) { ask_ = std::move(ask); }
    /// Replaces the menu that asks what an added file is, where its content may be trees or `other`.
    using AddQuestion = std::function<Added(Added other)>;
    void setAddQuestion(AddQuestion ask) { askAdded_ = std::move(ask); }

    [[nodiscard]] JobSlot& reading() { return reading_; }

Q_SIGNALS:
    void photographDropped(QString file);  ///< on an open city
    void treesFound(QString file);         ///< a file to be added holds trees

private:
    void makeActions();
    void connectTree(ProjectDock& tree);
    void askForFiles();
    [[nodiscard]] Added chooseContent(const QStringList& files) const;
    [[nodiscard]] bool mayOnlyBeTrees(const QStringList& files) const;
    [[nodiscard]] QString folderOfCity() const;
    void addPhotograph(const QString& file);
    void askForLayer(const QString& file, const std::vector<UnknownLayer>& layers,
                     const PlaceSettings& settings, EarlierPlaces earlier);
    using LoadPlaces = Result<PlacesRead> (*)(const std::vector<std::string>&, const PlaceSettings&,
                                              const Frame&, Progress&, const std::stop_token&);
    void startReading(const QStringList& files, PlaceSettings settings, EarlierPlaces earlier,
                      LoadPlaces load);
    void offerFile(const PlaceSettings& settings, EarlierPlaces earlier);
    void take(const PlacesRead& read, EarlierPlaces earlier);
    void takeDrawn(const std::vector<Footprint>& pieces);
    [[nodiscard]] std::string add(Place place, const QString& what);
    void follow();

    Workbench& workbench_;
    OpeningActions& opening_;
    EditTools& tools_;
    ViewPanel& panel_;
    ProjectDock& tree_;
    QWidget& window_;
    QAction* add_;
    QAction* read_;
    QAction* streets_;
    QAction* draw_;
    QAction* fromBuilding_;
    QAction* show_;
    QAction* outlines_;
    PlaceKind drawnKind_ = PlaceKind::park;
    DrawnPlace drawn_;
    std::function<Dropped()> ask_;
    AddQuestion askAdded_;
    JobSlot reading_;
};

/// "212 places were read; 3 replace earlier ones. 2 repaired: outline crossed itself (way 7)"
QString describePlacesRead(std::size_t places, const PlacesAdded& added, const Warnings& warnings);

}  // namespace noonmark
