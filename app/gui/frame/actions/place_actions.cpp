#include "app/gui/frame/actions/place_actions.h"

#include <QComboBox>
#include <QCursor>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <algorithm>
#include <glm/common.hpp>

#include "app/gui/base/files/file_dialogs.h"
#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/docks/project/project_dock.h"
#include "app/gui/frame/actions/opening_actions.h"
#include "app/gui/session/study/region_text.h"
#include "app/gui/session/workbench.h"
#include "app/gui/tools/editing/edit_tools.h"
#include "app/gui/tools/photograph/photograph_actions.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/input/load_city.h"
#include "app/report/sheets/study_text.h"
#include "core/io/files/plain_file.h"
#include "core/io/formats/format.h"
#include "core/io/trees/list_trees.h"
#include "core/receivers/place_names.h"
#include "scenarios/massing/lot_edits.h"

namespace noonmark {

namespace {

constexpr float minShownM = 150;  // side of the ground shown with a small place

// By the files' endings: they are read only after the user's choice.
bool mayHoldPlaces(const QStringList& files) {
    for (const QString& file : files)
        if (!findByEnding(file.toStdString(), FileKind::footprints) ||
            file.endsWith(QString::fromLatin1(projectEnding)))
            return false;
    return !files.isEmpty();
}

bool isMass(const QStringList& files) {
    return files.size() == 1 && findByEnding(files.front().toStdString(), FileKind::mesh);
}

PlaceActions::Dropped askByMenu() {
    QMenu menu;
    const QAction* places = menu.addAction(QObject::tr("Read &places into this project"));
    const QAction* city = menu.addAction(QObject::tr("&Open as another city"));
    const QAction* chosen = menu.exec(QCursor::pos());
    if (chosen == places) return PlaceActions::Dropped::readPlaces;
    return chosen == city ? PlaceActions::Dropped::open : PlaceActions::Dropped::nothing;
}

PlaceActions::Added askWhatIsAdded(PlaceActions::Added other) {
    QMenu menu;
    const QAction* trees =
        menu.addAction(other == PlaceActions::Added::terrain ? QObject::tr("&Heights of the trees' canopy")
                                                             : QObject::tr("&Trees"));
    const QAction* first = menu.addAction(other == PlaceActions::Added::terrain ? QObject::tr("T&errain")
                                                                                : QObject::tr("&Places"));
    const QAction* chosen = menu.exec(QCursor::pos());
    if (chosen == trees) return PlaceActions::Added::trees;
    return chosen == first ? other : PlaceActions::Added::nothing;
}

TreeContent findTreeContent(const QStringList& files) {
    if (files.size() != 1) return TreeContent::none;
    const auto listed = listTrees(files.front().toStdString(), {});
    return listed ? listed->content : TreeContent::none;
}

QComboBox* layerField(QFormLayout& form, const QString& label, const char* name) {
    auto* list = new QComboBox;
    list->setObjectName(QString::fromLatin1(name));
    form.addRow(label, list);
    return list;
}

// Which layer holds the places, what they are and which field names them. Not modal, as the form for files
// that are opened.
class LayerForm final : public QDialog {
public:
    using Chosen = std::function<void(const PlaceSettings&)>;
    LayerForm(std::vector<UnknownLayer> layers, PlaceSettings first, Chosen chosen, QWidget& parent)
        : QDialog(&parent),
          layers_(std::move(layers)),
          settings_(std::move(first)),
          form_(new QFormLayout(this)),
          layer_(layerField(*form_, QObject::tr("&Layer"), "placeLayer")),
          name_(layerField(*form_, QObject::tr("&Name"), "placeNameField")),
          chosen_(std::move(chosen)) {
        setAttribute(Qt::WA_DeleteOnClose);
        fill();
        connect(layer_, &QComboBox::currentIndexChanged, this, [this] { listNames(); });
        auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
        buttons->button(QDialogButtonBox::Ok)->setText(QObject::tr("Read"));
        connect(buttons, &QDialogButtonBox::accepted, this, [this] {
            accept();
            chosen_(settings());
        });
        connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
        form_->addRow(buttons);
    }

private:
    void fill() {
        for (const UnknownLayer& layer : layers_)
            layer_->addItem(QObject::tr("%1 (%2 features)")
                                .arg(QString::fromStdString(layer.name), formatCount(layer.features)));
        listNames();
        if (settings_.streets) return;
        kind_ = layerField(*form_, QObject::tr("&Kind"), "placeKind");
        for (const PlaceKind kind : placeKinds) kind_->addItem(describeKinds(kind), int(kind));
        kind_->setCurrentIndex(kind_->findData(int(settings_.kind)));
    }

    void listNames() {
        name_->clear();
        name_->addItem(QObject::tr("Found automatically"), QString());
        for (const std::string& field : layers_[std::size_t(layer_->currentIndex())].textFields)
            name_->addItem(QString::fromStdString(field), QString::fromStdString(field));
    }

    [[nodiscard]] PlaceSettings settings() const {
        PlaceSettings made = settings_;
        made.layer = layers_[std::size_t(layer_->currentIndex())].name;
        made.nameField = name_->currentData().toString().toStdString();
        if (kind_ != nullptr) made.kind = PlaceKind(kind_->currentData().toInt());
        return made;
    }

    std::vector<UnknownLayer> layers_;
    PlaceSettings settings_;
    QFormLayout* form_;
    QComboBox* layer_;
    QComboBox* name_;
    QComboBox* kind_ = nullptr;  // null: all are streets
    Chosen chosen_;
};

QString describeMoreKinds(std::size_t kinds) {
    return QObject::tr("%1 more kind(s) of notes", "", pluralNumber(kinds)).arg(formatCount(kinds));
}

}  // namespace

QString describePlacesRead(std::size_t places, const PlacesAdded& added, const Warnings& warnings) {
    QString text = QObject::tr("%1 place(s) were read", "", pluralNumber(places)).arg(formatCount(places));
    if (added.replaced > 0)
        text += QObject::tr("; %1 replace(s) earlier ones", "", pluralNumber(added.replaced))
                    .arg(formatCount(added.replaced));
    if (added.same > 0)
        text +=
            QObject::tr("; %1 place(s) were there before and stay as they are", "", pluralNumber(added.same))
                .arg(formatCount(added.same));
    text += u'.';
    constexpr std::size_t maximum = 3;
    const auto groups = groupWarnings(warnings);
    for (std::size_t i = 0; i < std::min(maximum, groups.size()); ++i)
        text += u'\n' + describeWarningWithPlaces(groups[i]);
    if (groups.size() > maximum) text += u'\n' + describeMoreKinds(groups.size() - maximum);
    return text;
}

PlaceActions::PlaceActions(Workbench& workbench, OpeningActions& opening, EditTools& tools, ViewPanel& panel,
                           ProjectDock& tree, QWidget& window)
    : workbench_(workbench),
      opening_(opening),
      tools_(tools),
      panel_(panel),
      tree_(tree),
      window_(window),
      add_(makeAction(
          this, tr("Add to the &city..."), {},
          tr("A terrain, an aerial photograph, trees, or parks and other places; what the city has "
             "stays"))),
      read_(makeAction(this, tr("Read &places..."), {},
                       tr("Parks, playgrounds, school grounds... from OpenStreetMap or any file of polygons"),
                       "place")),
      streets_(makeAction(this, tr("Read s&treets"), {},
                          tr("Streets from OpenStreetMap as places, cut at their junctions, carriageway and "
                             "sidewalks apart"),
                          "place")),
      draw_(makeAction(this, tr("Draw p&lace"), QKeySequence(tr("Ctrl+Shift+D")),
                       tr("Click corners on the ground; Enter finishes, Esc cancels"), "place")),
      fromBuilding_(makeAction(this, tr("Place from b&uilding outline"), {},
                               tr("Creates a place from the selected building's outline"))),
      show_(makeAction(this, tr("P&laces"), Qt::Key_P, tr("Shows names of places"))),
      outlines_(makeAction(this, tr("Outlines of all places"), {},
                           tr("Without it, the outline of the chosen place is shown, and of the one under "
                              "the cursor"))),
      ask_(askByMenu),
      askAdded_(askWhatIsAdded) {
    makeActions();
    connectTree(tree);
    connect(&workbench_.session(), &ProjectSession::changed, this, &PlaceActions::follow);
    connect(&workbench_, &Workbench::cityShown, this, &PlaceActions::follow);
    connect(&panel_.placeTool(), &PolygonTool::finished, this, &PlaceActions::takeDrawn);
    connect(&panel_, &ViewPanel::filesDropped, this,
            [this](const QStringList& files, QPointF pixel) { takeDropped(files, pixel); });
}

void PlaceActions::makeActions() {
    draw_->setObjectName(QStringLiteral("drawPlace"));
    show_->setCheckable(true);
    show_->setChecked(true);
    outlines_->setObjectName(QStringLiteral("placeOutlines"));
    outlines_->setCheckable(true);
    fromBuilding_->setEnabled(false);
    add_->setObjectName(QStringLiteral("addToCity"));
    connect(add_, &QAction::triggered, this, [this] {
        if (const QStringList files = askForCity(&window_); !files.isEmpty()) addFiles(files);
    });
    connect(read_, &QAction::triggered, this, &PlaceActions::askForFiles);
    connect(streets_, &QAction::triggered, this, &PlaceActions::readStreets);
    connect(draw_, &QAction::triggered, this, [this] { draw(); });
    connect(fromBuilding_, &QAction::triggered, this, &PlaceActions::makeFromBuilding);
    connect(show_, &QAction::toggled, this, [this](bool on) {
        panel_.view().places().setShown(on);
        outlines_->setEnabled(on);
    });
    connect(outlines_, &QAction::toggled, this,
            [this](bool on) { panel_.view().places().setOutlinesShown(on); });
    connect(&tools_.building(), &BuildingEditing::selectionChanged, this,
            [this] { fromBuilding_->setEnabled(tools_.building().selected().has_value()); });
}

void PlaceActions::connectTree(ProjectDock& tree) {
    connect(&tree, &ProjectDock::placeChosen, this, &PlaceActions::zoomTo);
    connect(&tree, &ProjectDock::placeSelected, &panel_, &ViewPanel::highlightPlace);
    connect(&tree, &ProjectDock::drawPlaceRequested, this, [this] { draw(); });
    connect(&tree, &ProjectDock::readPlacesRequested, this, &PlaceActions::askForFiles);
}

void PlaceActions::follow() {
    if (workbench_.city()) panel_.showPlaces(workbench_.session().project().places);
}

void PlaceActions::askForFiles() {
    if (!workbench_.city()) return panel_.messages().showError(noCityError());
    read(askForPlaces(&window_, folderOfCity()));
}

// Maps of a city's places lie beside its buildings more often than in the working directory.
QString PlaceActions::folderOfCity() const {
    if (const auto& project = workbench_.session().file())
        return QString::fromStdString(project->path().parent_path().string());
    const QStringList& files = workbench_.source().files;
    const bool isFile = !files.isEmpty() && !isSample(files.front().toStdString());
    return isFile ? QFileInfo(files.front()).absolutePath() : QString();
}

// Those of the city as it was opened, or of the files that its project was made from.
void PlaceActions::readStreets() {
    if (!workbench_.city()) return panel_.messages().showError(noCityError());
    QStringList files = workbench_.source().files;
    for (const InputFile& input : workbench_.session().project().inputs)
        files << QString::fromStdString(input.path.string());
    files.removeDuplicates();
    const PlaceSettings streets{.kinds = {PlaceKind::street},
                                .streets = true,
                                .wholeStreets = false,
                                .sidewalkM = PlaceSettings::defaultSidewalkM};
    startReading(files, streets, EarlierPlaces::areReplaced, &loadCityPlaces);
}

void PlaceActions::read(const QStringList& files, const PlaceSettings& settings, EarlierPlaces earlier) {
    if (files.isEmpty() || !workbench_.city()) return;
    const auto load = [](const std::vector<std::string>& names, const PlaceSettings& wanted,
                         const Frame& frame, Progress& progress, const std::stop_token& stop) {
        return loadPlaceFiles(names, wanted, frame, {}, progress, stop);
    };
    startReading(files, settings, earlier,
                 isParkSample(files.front().toStdString()) ? &loadCityPlaces : +load);
}

void PlaceActions::startReading(const QStringList& files, PlaceSettings settings, EarlierPlaces earlier,
                                LoadPlaces load) {
    std::vector<std::string> names;
    for (const QString& file : files) names.push_back(file.toStdString());
    settings.listLayers = names.size() == 1;
    reading_.start<PlacesRead>(
        tr("Reading places"),
        [names, settings, load, frame = workbench_.city()->city().frame](Progress& progress,
                                                                         const std::stop_token& stop) {
            return load(names, settings, frame, progress, stop);
        },
        [this, settings, earlier, file = files.value(0)](Result<PlacesRead> read) {
            if (read && !read->layers.empty()) return askForLayer(file, read->layers, settings, earlier);
            if (!read && isCancelled(read.error())) return;
            read ? take(*read, earlier) : panel_.messages().showError(read.error());
            if (settings.streets && (!read || read->places.empty())) offerFile(settings, earlier);
        });
}

// The city's own file may have no streets, though its layers might hold lines.
void PlaceActions::offerFile(const PlaceSettings& settings, EarlierPlaces earlier) {
    panel_.messages().offer(tr("Choose a file..."), [this, settings, earlier] {
        read(askForPlaces(&window_, folderOfCity()), settings, earlier);
    });
}

void PlaceActions::askForLayer(const QString& file, const std::vector<UnknownLayer>& layers,
                               const PlaceSettings& settings, EarlierPlaces earlier) {
    auto* form = new LayerForm(
        layers, settings,
        [this, file, earlier](const PlaceSettings& chosen) { read({file}, chosen, earlier); }, window_);
    form->setWindowTitle(tr("Which layer of %1 holds the places?").arg(QFileInfo(file).fileName()));
    form->show();
}

void PlaceActions::take(const PlacesRead& read, EarlierPlaces earlier) {
    if (read.places.empty())
        return panel_.messages().showError(
            {QT_TRANSLATE_NOOP("Error", "The file holds no such places near the city"),
             {},
             QT_TRANSLATE_NOOP("Error",
                               "Choose a map of this city with parks or streets, or a file of polygons")});
    PlacesAdded added;
    const auto join = earlier == EarlierPlaces::stay ? withMorePlaces : withPlaces;
    Project next = join(workbench_.session().project(), read.places, added);
    const bool changes = added.added + added.replaced > 0;
    if (changes && !workbench_.session().change(std::move(next), tr("read places"))) return;
    if (earlier == EarlierPlaces::areReplaced) outlines_->setChecked(true);  // asked for: they are to be seen
    const QString text = describePlacesRead(read.places.size(), added, read.warnings);
    read.warnings.empty() ? panel_.messages().showNote(text) : panel_.messages().showHelp(text);
}

void PlaceActions::takeDropped(const QStringList& files, std::optional<QPointF> pixel) {
    if (workbench_.city() && isMass(files)) {
        const auto ground = pixel ? panel_.navigator().groundAt(*pixel) : std::nullopt;
        return tools_.placeMesh(files.front(), ground ? std::optional(glm::dvec2(*ground)) : std::nullopt);
    }
    if (workbench_.city() && isPhotograph(files)) return Q_EMIT photographDropped(files.front());
    if (workbench_.city() && mayOnlyBeTrees(files)) return Q_EMIT treesFound(files.front());
    const Dropped wanted = workbench_.city() && mayHoldPlaces(files) ? ask_() : Dropped::open;
    if (wanted == Dropped::open) opening_.open(files);
    if (wanted == Dropped::readPlaces) read(files);
}

void PlaceActions::addFiles(const QStringList& files) {
    if (!workbench_.city()) return panel_.messages().showError(noCityError());
    if (isPhotograph(files)) return addPhotograph(files.front());
    const Added content = chooseContent(files);
    if (content == Added::trees) Q_EMIT treesFound(files.front());
    if (content == Added::terrain) opening_.addTerrain(files);
    if (content == Added::places) read(files, {}, EarlierPlaces::stay);
}

// A second raster of elevations is that of crowns, if it looks like one.
bool PlaceActions::mayOnlyBeTrees(const QStringList& files) const {
    const TreeContent trees = findTreeContent(files);
    return trees == TreeContent::inventory ||
           (trees == TreeContent::canopy && workbench_.city()->city().terrain);
}

// A raster of elevations may be that of crowns, and a map has places and trees.
PlaceActions::Added PlaceActions::chooseContent(const QStringList& files) const {
    if (mayOnlyBeTrees(files)) return Added::trees;
    const TreeContent trees = findTreeContent(files);
    if (trees == TreeContent::canopy) return askAdded_(Added::terrain);
    if (trees == TreeContent::map) return askAdded_(Added::places);
    const bool areTerrain = std::ranges::all_of(files, [](const QString& file) {
        const auto kind = detectFileKind(file.toStdString());
        return kind && *kind == FileKind::terrain;
    });
    return areTerrain ? Added::terrain : Added::places;
}

void PlaceActions::addPhotograph(const QString& file) {
    if (workbench_.session().project().groundPicture)
        return panel_.messages().showError(
            {QT_TRANSLATE_NOOP("Error", "The city has an aerial photograph already"), file.toStdString(),
             QT_TRANSLATE_NOOP("Error", "Remove it first: File > Aerial photograph")});
    Q_EMIT photographDropped(file);
}

void PlaceActions::draw(PlaceKind kind, DrawnPlace named) {
    if (!workbench_.city()) return panel_.messages().showError(noCityError());
    drawnKind_ = kind;
    drawn_ = std::move(named);
    panel_.placeTool().begin();
    panel_.view().requestActivate();  // the view receives the keys that finish or cancel the polygon
}

void PlaceActions::takeDrawn(const std::vector<Footprint>& pieces) {
    const std::string name = add({"Place", drawnKind_, pieces, "drawn"}, tr("draw place"));
    if (name.empty()) return;
    if (drawn_) return drawn_(name);
    tree_.editName(ProjectPart::place, name);
    panel_.messages().showNote(tr("%1 is drawn as %2; a right click on it in Project changes its kind.")
                                   .arg(placeName(name), describeKind(drawnKind_)));
}

void PlaceActions::makeFromBuilding() {
    const auto selected = tools_.building().selected();
    if (!selected || !workbench_.city()) return;
    const Building& building = *workbench_.city()->city().buildings[*selected];
    const std::string name = cleanName(building.name.empty() ? building.sourceId : building.name);
    const std::string added = add({name.empty() ? "Place" : name, PlaceKind::other, computeOutline(building),
                                   "building " + cleanName(building.sourceId)},
                                  tr("place from building"));
    if (!added.empty()) tree_.editName(ProjectPart::place, added);
}

// The name that it got, which can be typed at once. Empty: it was not added.
std::string PlaceActions::add(Place place, const QString& what) {
    Project next = workbench_.session().project();
    place.name = freeName(next, ProjectPart::place, place.name);
    const std::string name = place.name;
    next.places.push_back(std::move(place));
    return workbench_.session().change(std::move(next), what) ? name : std::string();
}

void PlaceActions::zoomTo(const std::string& name) {
    const auto place = findPlace(workbench_.session().project(), name);
    if (!place)
        return panel_.messages().showError(
            {QT_TRANSLATE_NOOP("Error", "The project has no place of this name any more"), name,
             QT_TRANSLATE_NOOP("Error", "Run again, so that the table lists the places as they are")});
    Box2 box = bounds(*place);
    const glm::vec2 border =
        glm::max((box.high - box.low) * 0.25F, (glm::vec2(minShownM) - (box.high - box.low)) * 0.5F);
    panel_.navigator().show({box.low - border, box.high + border});
    panel_.highlightPlace(place->name);
}

}  // namespace noonmark
