#pragma once

#include <QObject>

#include "app/gui/view/time/moment_preview.h"
#include "render/view/camera_pose.h"
#include "render/view/section_box.h"
#include "scenarios/project/project.h"

class QAction;
class QMenu;
class QWidget;

namespace noonmark {

class ProjectDock;
class ProjectSession;
class ViewPanel;

/// A view of this name as it is displayed; a whole period or a day has no moment. `section`: none shows the
/// whole city.
SavedView makeSavedView(const std::string& name, const CameraPose& pose, const ShownTime& look,
                        const std::optional<SectionBox>& section = std::nullopt);
CameraPose poseOf(const SavedView& view);
std::optional<SectionBox> sectionOf(const SavedView& view);

/// View > Saved views: saves the view in the project and shows one again. The project's tree renames and
/// deletes them.
class SavedViews final : public QObject {
    Q_OBJECT
public:
    /// The menu belongs to `window`. All must outlive this object.
    SavedViews(ProjectSession& session, ViewPanel& panel, ProjectDock& tree, QWidget& window);

    [[nodiscard]] QMenu* menu() const { return menu_; }

public Q_SLOTS:
    void save();  ///< under an unused name, which the project's tree offers to change
    void show(const std::string& name);

private:
    void fillMenu();

    ProjectSession& session_;
    ViewPanel& panel_;
    ProjectDock& tree_;
    QMenu* menu_;
    QAction* save_;
};

}  // namespace noonmark
