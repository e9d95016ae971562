#include "app/gui/frame/help/about_text.h"

#include <QGuiApplication>
#include <QObject>
#include <QSysInfo>

#include "app/input/build_facts.h"
#include "render/view/software_drawing.h"

namespace noonmark {

QString makeAboutText() {
    const QString graphics = drawsInSoftware()
                                 ? QObject::tr("Graphics: OpenGL on the processor; a graphics card is faster")
                                 : QObject::tr("Graphics: OpenGL on a graphics card");
    return QString::fromStdString(buildFactsText()).trimmed() + QLatin1Char('\n') + graphics +
           QLatin1Char('\n') +
           QObject::tr("System: %1, %2").arg(QSysInfo::prettyProductName(), QGuiApplication::platformName());
}

}  // namespace noonmark
