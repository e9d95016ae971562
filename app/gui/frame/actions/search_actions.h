#pragma once

#include <QObject>

#include "app/gui/docks/search/city_search.h"

class QAction;
class QMenuBar;
class QWidget;

namespace noonmark {

class EditTools;
class SearchField;
class ViewPanel;
class Workbench;

/// Finds what the user types: moves the camera there and selects a building, or runs a command.
class SearchActions final : public QObject {
    Q_OBJECT
public:
    /// All must outlive this object.
    SearchActions(Workbench& workbench, EditTools& tools, ViewPanel& panel);

    /// Finds the commands of these menus, too; they must outlive this object.
    void findCommandsOf(const QMenuBar& menus);

    [[nodiscard]] SearchField* field() const { return field_; }  ///< its parent takes ownership
    [[nodiscard]] QAction* action() const { return find_; }

private:
    void renew();
    void show(const Found& found);

    Workbench& workbench_;
    EditTools& tools_;
    ViewPanel& panel_;
    SearchField* field_;
    QAction* find_;
    const QMenuBar* menus_ = nullptr;
};

}  // namespace noonmark
