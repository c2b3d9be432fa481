// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/feel/feel_panel.h"

#include <algorithm>
#include <QAction>
#include <QBoxLayout>
#include <QButtonGroup>
#include <QFileDialog>
#include <QFileInfo>
#include <QHideEvent>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>

#include "editor/document/described.h"
#include "editor/document/message_words.h"
#include "editor/document/state_name.h"
#include "editor/feel/feel_clock.h"
#include "editor/feel/feel_setup.h"
#include "editor/feel/force_box.h"
#include "editor/feel/force_setup.h"
#include "editor/feel/press_pad.h"
#include "editor/feel/press_strip.h"
#include "editor/feel/setup_widgets.h"
#include "editor/feel/signal_view.h"
#include "editor/feel/sound_box.h"

namespace detent::editor {
namespace {

constexpr double stripTail_s = 0.3;  // the strip continues this long after a press
constexpr double wideRatio = 1.35;   // wider than this, the parts stand side by side
constexpr int leastControls_px = 120;
// largest ratio of two signals' durations that are drawn to one scale
constexpr double comparableDurations = 4;
constexpr int longestNote = 200;
constexpr int leastOfTwoViews_px = 140;  // a low dock has room for two views
constexpr FeelSide sides[] = {FeelSide::a, FeelSide::b};

PadButton padButtonOf(const ButtonDocument& document, std::size_t state, double full_N) {
  const Button& button = document.button();
  const std::size_t shownState = std::min(state, button.states().size() - 1);
  const ButtonState& shown = button.states()[shownState];
  const StrokeCurve& press = shown.graph.press();
  PadButton pad;
  pad.name = button.name().empty() ? document.title() : QString::fromStdString(button.name());
  if (button.selfLocking()) pad.stateName = nameOfState(button, shownState);
  pad.start_mm = press.start_mm();
  pad.end_mm = press.end_mm();
  pad.full_N = full_N;
  pad.pressPoints = tactilePoints(press, Stroke::press);
  if (shown.graph.release())
    pad.releasePoints = tactilePoints(shown.graph.curve(Stroke::release), Stroke::release);
  pad.operating_mm = shown.operatingPoint_mm;
  pad.reset_mm = shown.resetPoint_mm;
  return pad;
}

/// A row or column without margins of its own.
template <class Layout>
Layout* bare(Layout* layout, int spacing_px) {
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(spacing_px);
  return layout;
}

}  // namespace

FeelPanel::FeelPanel(ViewSettings& settings, FeelSession& session, QWidget* parent)
    : QWidget(parent), session_(session) {
  setAccessibleName(tr("Feel"));
  sections_ = new QBoxLayout(QBoxLayout::TopToBottom, this);
  sections_->setContentsMargins(8, 8, 8, 8);
  sections_->setSpacing(8);
  sections_->addWidget(padColumn(settings), 5);
  sections_->addWidget(viewColumn(), 4);
  sections_->addWidget(controlColumn(settings), 0);
  connectPad();
  connectSession();
  showSettings();
  showPair();
  showFelt();
  showReference();
}

// ---- widgets

QWidget* FeelPanel::padColumn(ViewSettings& settings) {
  pad_ = described(new PressPad(settings), "pressPad");
  strip_ = described(new PressStrip, "pressStrip");
  auto* whole = new QWidget;
  auto* column = bare(new QVBoxLayout(whole), 6);
  column->addLayout(choiceRow());
  column->addWidget(pad_, 1);
  column->addWidget(strip_);
  return whole;
}

QWidget* FeelPanel::viewColumn() {
  view_ = described(new SignalView, "signalView");
  auto* whole = new QWidget;
  auto* column = bare(new QVBoxLayout(whole), 6);
  referenceView_ = described(new SignalView, "referenceView");
  referenceNote_ = noteLabel("referenceNote");
  column->addLayout(pressRow());
  column->addWidget(view_, 1);
  column->addLayout(referenceRow());
  column->addWidget(referenceNote_);
  column->addWidget(referenceView_, 1);
  return whole;
}

QWidget* FeelPanel::setupPage(ViewSettings& settings) {
  setup_ = new FeelSetup(settings, session_.soundDevices());
  forceSetup_ = new ForceSetup(settings);
  auto* page = new QWidget;
  auto* column = bare(new QVBoxLayout(page), 4);
  column->addWidget(setup_);
  column->addWidget(forceSetup_);
  column->addStretch();
  return page;
}

QWidget* FeelPanel::controlColumn(ViewSettings& settings) {
  setupPage_ = setupPage(settings);
  setupPage_->hide();
  setupToggle_ =
      described(new QToolButton, "setupToggle", tr("Set up pad, feedback, devices and force sensor"));
  setupToggle_->setText(tr("Setup"));
  setupToggle_->setCheckable(true);
  setupToggle_->setArrowType(Qt::RightArrow);
  setupToggle_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  connect(setupToggle_, &QToolButton::toggled, this, [this](bool open) {
    setupToggle_->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    setupPage_->setVisible(open);
    layOut();
  });
  auto* whole = new QWidget;
  auto* column = bare(new QVBoxLayout(whole), 6);
  column->addWidget(new SoundBox(session_));
  column->addWidget(new ForceBox(settings, session_.force()));
  column->addWidget(setupToggle_, 0, Qt::AlignLeft);
  column->addWidget(setupPage_);
  column->addStretch(1);
  // A low dock has no room for all parts, so the content scrolls.
  auto* area = new QScrollArea;
  area->setAccessibleName(tr("Sound, force and setup"));
  area->setWidget(whole);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  const int least_px = std::max(whole->minimumSizeHint().width(), setupPage_->minimumSizeHint().width());
  area->setMinimumSize(least_px + area->verticalScrollBar()->sizeHint().width(), leastControls_px);
  return area;
}

QAction* FeelPanel::ownAction(const char* name, const QString& text, const QString& tip, Qt::Key key) {
  auto* action = described(new QAction(text, this), name, tip);
  action->setShortcut(key);
  action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  addAction(action);
  return action;
}

QToolButton* FeelPanel::buttonOf(QAction* action, const char* name, const QString& text) {
  auto* button =
      described(new QToolButton, name,
                tr("%1 (%2)").arg(action->toolTip(), action->shortcut().toString(QKeySequence::NativeText)),
                action->text());
  button->setText(text);
  button->setEnabled(action->isEnabled());
  connect(button, &QToolButton::clicked, action, &QAction::trigger);
  connect(action, &QAction::enabledChanged, button, &QWidget::setEnabled);
  return button;
}

QLayout* FeelPanel::choiceRow() {
  exchange_ = ownAction("exchangeButtons", tr("Press the other button (A or B)"),
                        tr("Switch between A and B while pressing. Both are played at their true strength, "
                           "without loudness matching."),
                        Qt::Key_X);
  connect(exchange_, &QAction::triggered, &session_, &FeelSession::exchange);
  auto* row = bare(new QHBoxLayout, 4);
  auto* group = new QButtonGroup(this);
  for (const FeelSide side : sides) {
    auto* choice = new QToolButton;
    choice->setObjectName(side == FeelSide::a ? "feelA" : "feelB");
    choice->setCheckable(true);
    choice->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    group->addButton(choice);
    row->addWidget(choice, 1);
    choices_[static_cast<std::size_t>(side)] = choice;
    connect(choice, &QToolButton::clicked, this, [this, side] { session_.feel(side); });
  }
  row->addWidget(buttonOf(exchange_, "exchange", QStringLiteral("X")));
  return row;
}

/// Row with the choice of the press that is drawn and played.
QLayout* FeelPanel::pressRow() {
  auto* row = bare(new QHBoxLayout, 4);
  auto* group = new QButtonGroup(this);
  const auto choice = [&](const char* name, const QString& text, const QString& tip, bool own) {
    auto* button = described(new QToolButton, name, tip);
    button->setText(text);
    button->setCheckable(true);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    group->addButton(button);
    row->addWidget(button, 1);
    connect(button, &QToolButton::clicked, this, [this, own] { session_.drawOwnPress(own); });
    return button;
  };
  standardPress_ = choice("standardPress", tr("Standard press"),
                          tr("Show and play a standard press: 120 ms down, 80 ms held, 100 ms up"), false);
  myPress_ = choice("myPress", tr("My last press"),
                    tr("Show and play your own last press. It is repeated on A, on B and after every edit, "
                       "so that all are pressed in the same way"),
                    true);
  standardPress_->setChecked(true);
  play_ = ownAction("playPress", tr("Play the press shown"),
                    tr("Send the press shown to the sound device; no finger is needed"), Qt::Key_P);
  connect(play_, &QAction::triggered, this, [this] {
    session_.play();
    showPresses();
  });
  row->addWidget(buttonOf(play_, "play", tr("Play")));
  return row;
}

/// Signal of another program, for comparison.
QLayout* FeelPanel::referenceRow() {
  referenceChoice_ = described(new QToolButton, "referenceFile",
                               tr("Compare with a signal of another program: AHAP, .haptic, HJIF, WAV"));
  referenceChoice_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  connect(referenceChoice_, &QToolButton::clicked, this, &FeelPanel::chooseReference);
  playReference_ = ownAction(
      "playReference", tr("Play the reference"),
      tr("Play the reference on the sound device, at the same gain as the press; click again to stop"),
      Qt::Key_R);
  connect(playReference_, &QAction::triggered, this, [this] {
    session_.player().samplesPlaying() ? session_.stopReference() : session_.playReference();
    showPresses();
  });
  referencePlay_ = buttonOf(playReference_, "playReferenceButton", tr("Play"));
  noReference_ = described(new QToolButton, "noReference", tr("Remove the reference"));
  noReference_->setText(QStringLiteral("×"));
  connect(noReference_, &QToolButton::clicked, &session_, [this] { session_.setReference({}); });
  auto* row = bare(new QHBoxLayout, 4);
  row->addWidget(referenceChoice_, 1);
  row->addWidget(referencePlay_);
  row->addWidget(noReference_);
  return row;
}

void FeelPanel::chooseReference() {
  const QString file = QFileDialog::getOpenFileName(
      this, tr("Reference signal"), QFileInfo(session_.settings().referenceFile).path(),
      tr("Signals (*.ahap *.haptic *.hjif *.wav *.flac *.aiff *.ogg);;All files (*)"));
  if (!file.isEmpty()) session_.setReference(file);
}

void FeelPanel::layOut() {
  const bool sideBySide = width() > wideRatio * height();
  sections_->setDirection(sideBySide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  sections_->activate();
  writeNames();
  sections_->setStretch(2, sideBySide ? 3 : (setupPage_->isVisibleTo(this) ? 4 : 0));
}

// ---- between widgets and session

void FeelPanel::connectPad() {
  connect(pad_, &PressPad::timedDown, &session_, &FeelSession::down);
  connect(pad_, &PressPad::timedUp, &session_, &FeelSession::up);
  connect(pad_, &PressPad::forceMoved, &session_, &FeelSession::pushForce);
  connect(pad_, &PressPad::depthMoved, &session_, &FeelSession::pushDepth);
  connect(pad_, &PressPad::lifted, &session_, &FeelSession::lift);
}

void FeelPanel::connectSession() {
  connect(setup_, &FeelSetup::changed, &session_, &FeelSession::setSettings);
  connect(forceSetup_, &ForceSetup::changed, &session_, [this](const ForceChoices& choices) {
    FeelSettings next = session_.settings();
    next.force = choices;
    session_.setSettings(next);
  });
  connect(&session_, &FeelSession::settingsChanged, this, &FeelPanel::showSettings);
  connect(&session_, &FeelSession::sensorOffered, setup_, &FeelSetup::offerPort);
  connect(&session_, &FeelSession::pairChanged, this, &FeelPanel::showPair);
  connect(&session_, &FeelSession::feltChanged, this, &FeelPanel::showFelt);
  connect(&session_, &FeelSession::stateChanged, this, &FeelPanel::showPad);
  connect(&session_, &FeelSession::ownPressChanged, this, &FeelPanel::showPresses);
  connect(&session_, &FeelSession::referenceChanged, this, &FeelPanel::showReference);
  connect(&session_, &FeelSession::moved, this, &FeelPanel::follow);
  connect(&session_, &FeelSession::eventsFelt, this, &FeelPanel::showEvents);
  const FeelPlayer& player = session_.player();
  connect(&player, &FeelPlayer::soundChanged, this, &FeelPanel::showPresses);
  connect(&player, &FeelPlayer::sensorChanged, this,
          [this, &player] { setup_->setSensor(player.status(), player.sensorTrouble()); });
}

/// Names on the two buttons above the pad, and whether they can be pressed.
void FeelPanel::showPair() {
  for (const FeelSide side : sides) {
    QToolButton* choice = choices_[static_cast<std::size_t>(side)];
    const ButtonDocument* document = session_.document(side);
    choice->setEnabled(document != nullptr);
    choice->setToolTip(document              ? tr("Press %1").arg(document->title())
                       : side == FeelSide::a ? tr("No button is open")
                                             : tr("Choose a second button to compare with"));
    choice->setAccessibleName(choice->toolTip());
  }
  exchange_->setEnabled(session_.exchangeable());
  writeNames();
}

/// Shortens the names to the available space.
void FeelPanel::writeNames() {
  for (const FeelSide side : sides) {
    QToolButton* choice = choices_[static_cast<std::size_t>(side)];
    const ButtonDocument* document = session_.document(side);
    const QString name = (side == FeelSide::a ? QStringLiteral("A  ") : QStringLiteral("B  ")) +
                         (document ? document->title() : QStringLiteral("–"));
    choice->setText(choice->fontMetrics().elidedText(name, Qt::ElideRight, choice->width() - 14));
  }
  const QString file = QFileInfo(session_.settings().referenceFile).fileName();
  referenceChoice_->setText(
      referenceChoice_->fontMetrics().elidedText(file.isEmpty() ? tr("Compare with a reference…") : file,
                                                 Qt::ElideMiddle, referenceChoice_->width() - 14));
  referenceChoice_->setAccessibleName(file.isEmpty() ? tr("Compare with a reference…")
                                                     : tr("Reference: %1").arg(file));
}

void FeelPanel::showFelt() {
  choices_[static_cast<std::size_t>(session_.feltSide())]->setChecked(true);
  view_->setSignal(session_.signal());
  showScale();
  showPad();
  showPresses();
}

void FeelPanel::showPad() {
  const auto& signal = session_.signal();
  if (!session_.program()) {
    const bool failed = signal && signal->failure;
    pad_->setButton(
        std::nullopt,
        failed ? tr("This button cannot be pressed: %1").arg(sentenceOf(*signal->failure)) : QString());
  } else if (!playback::livePlaybackAvailable()) {
    pad_->setButton(std::nullopt, tr("This build of Detent has no live playback, so the pad cannot be "
                                     "pressed. The vibration is shown below."));
  } else {
    pad_->setButton(padButtonOf(*session_.feltDocument(), session_.state(), session_.full_N()));
  }
}

void FeelPanel::showPresses() {
  myPress_->setEnabled(session_.ownPressKnown());
  play_->setEnabled(session_.playable());
  const bool sounds = session_.player().samplesPlaying();
  playReference_->setEnabled(session_.reference() && (sounds || session_.playable()));
  referencePlay_->setText(sounds ? tr("Stop") : tr("Play"));
}

void FeelPanel::showReference() {
  const auto& reference = session_.reference();
  const QString name = QFileInfo(session_.settings().referenceFile).fileName();
  QStringList notes;
  if (!session_.referenceTrouble().isEmpty()) notes << session_.referenceTrouble();
  if (reference)
    for (const Message& note : reference->notes) notes << asSentence(inWords(note));
  referenceNote_->setText(shortened(notes.join(' '), longestNote));
  referenceNote_->setToolTip(notes.join('\n'));
  referenceNote_->setVisible(!notes.isEmpty());
  for (QWidget* part : std::initializer_list<QWidget*>{referenceView_, referencePlay_, noReference_})
    part->setVisible(reference != nullptr);
  for (SignalView* view : {view_, referenceView_}) view->setMinimumHeight(reference ? leastOfTwoViews_px : 0);
  referenceView_->setReference(reference, name);
  showScale();
  showPresses();
  writeNames();
}

/// Draws both signals on one scale, unless one of them would become invisible.
void FeelPanel::showScale() {
  const auto& press = session_.signal();
  const auto& reference = session_.reference();
  const bool comparable = press && !press->failure && reference;
  const double longer_s = comparable ? std::max(press->duration_s(), reference->duration_s()) : 0;
  const double shorter_s = comparable ? std::min(press->duration_s(), reference->duration_s()) : 0;
  const double duration_s = longer_s <= comparableDurations * shorter_s ? longer_s : 0;
  const double peak = comparable ? std::max(press->peak, reference->peak) : 0;
  view_->setLeast(duration_s, peak);
  referenceView_->setLeast(duration_s, peak);
}

void FeelPanel::showSettings() {
  pad_->setDrive(session_.settings().drive);
  setup_->setProfile(session_.profile(), session_.profileTrouble());
  if (!(setup_->settings() == session_.settings())) setup_->setSettings(session_.settings());
  if (!(forceSetup_->choices() == session_.settings().force))
    forceSetup_->setChoices(session_.settings().force);
  showPad();
  showPresses();
}

void FeelPanel::follow() {
  const FeelMotion& motion = session_.motion();
  pad_->setMotion({motion.displacement_mm, motion.force_N, motion.pressed, motion.releasing, motion.contact});
  const double now_s = steadyTime_s();
  if (motion.pressed) lastPressed_s_ = now_s;
  const playback::StateProgram* state = session_.pressedState();
  if (now_s - lastPressed_s_ < stripTail_s && state != nullptr) {
    const double travel_mm = state->end_mm - state->start_mm;
    const double depth = travel_mm > 0 ? (motion.displacement_mm - state->start_mm) / travel_mm : 0;
    strip_->addMoment({now_s, depth, motion.releasing, motion.contact});
  }
  const playback::PlayerStatus& status = session_.player().status();
  if (session_.player().sound() == SoundState::on) setup_->setBuffer(status.blockFrames);
  setup_->setSensor(status, session_.player().sensorTrouble());
  showPresses();
}

void FeelPanel::showEvents(const std::vector<playback::EngineEvent>& events) {
  using playback::EventKind;
  for (const playback::EngineEvent& event : events) {
    if (event.kind == EventKind::pressJump) pad_->flash(PressPad::Lamp::pressJump);
    if (event.kind == EventKind::releaseJump) pad_->flash(PressPad::Lamp::releaseJump);
    if (event.kind == EventKind::bottomOut) pad_->flash(PressPad::Lamp::bottomOut);
  }
  const double rate_Hz = session_.player().status().sampleRate_Hz;
  strip_->addEvents(events, steadyTime_s(), rate_Hz > 0 ? rate_Hz : drawnRate_Hz);
}

// ---- panel

void FeelPanel::takeKeys() { pad_->setFocus(); }

QVariantMap FeelPanel::saveState() const {
  QVariantMap state = session_.saveState();
  state["setupShown"] = setupToggle_->isChecked();
  return state;
}

void FeelPanel::restoreState(const QVariantMap& state) {
  session_.restoreState(state);
  setupToggle_->setChecked(state.value("setupShown").toBool());
}

void FeelPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  session_.setWatched(true);
  // The rows get their widths when the whole panel is laid out.
  QMetaObject::invokeMethod(this, &FeelPanel::writeNames, Qt::QueuedConnection);
}

// A minimised panel keeps its press running; only a hidden one ends it.
void FeelPanel::hideEvent(QHideEvent* event) {
  if (!event->spontaneous()) session_.setWatched(false);
  QWidget::hideEvent(event);
}

void FeelPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  layOut();
}

}  // namespace detent::editor
