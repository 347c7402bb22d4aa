/* Commands that the host carries out: requests sent to it with the next frame. */
#include "editor/tables/commands.h"
#include "editor/edit/clipboard.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"

bat_status bat_command_ask(bat_context *c, bat_command_id id) {
    static const struct {
        bat_command_id id;
        uint32_t request;
    } requests[] = {{BAT_COMMAND_OPEN, BAT_ASK_OPEN},
                    {BAT_COMMAND_OPEN_KEPT, BAT_ASK_KEPT},
                    {BAT_COMMAND_LOSSES, BAT_ASK_LOSSES},
                    {BAT_COMMAND_SAVE, BAT_ASK_SAVE},
                    {BAT_COMMAND_SAVE_AS, BAT_ASK_SAVE_AS},
                    {BAT_COMMAND_DOWNLOAD_SVG, BAT_ASK_DOWNLOAD_SVG},
                    {BAT_COMMAND_DOWNLOAD_NATIVE, BAT_ASK_DOWNLOAD_NATIVE},
                    {BAT_COMMAND_EXPORT, BAT_ASK_EXPORT},
                    {BAT_COMMAND_EXPORT_AGAIN, BAT_ASK_EXPORT_AGAIN},
                    {BAT_COMMAND_HISTORY, BAT_ASK_HISTORY},
                    {BAT_COMMAND_DOWNLOAD_JOURNAL, BAT_ASK_JOURNAL},
                    {BAT_COMMAND_CUT, BAT_ASK_CUT},
                    {BAT_COMMAND_COPY, BAT_ASK_COPY},
                    {BAT_COMMAND_COPY_PICTURE, BAT_ASK_COPY_PICTURE},
                    {BAT_COMMAND_PASTE, BAT_ASK_PASTE},
                    {BAT_COMMAND_PASTE_IN_PLACE, BAT_ASK_PASTE},
                    {BAT_COMMAND_SHORTCUTS, BAT_ASK_SHORTCUTS},
                    {BAT_COMMAND_REGION_NEXT, BAT_ASK_REGION},
                    {BAT_COMMAND_REGION_PREVIOUS, BAT_ASK_REGION_BACK}};
    if (id == BAT_COMMAND_LOSSES && !bat_losses_total(&c->session->losses)) {
        bat_notice(c, BAT_STRING_NOTICE_KEEPS_ALL);
        return BAT_OK;
    }
    if (id == BAT_COMMAND_SAVE && bat_session_refuses(c)) return BAT_OK;
    c->clipboard->paste_in_place = id == BAT_COMMAND_PASTE_IN_PLACE;
    for (size_t i = 0; i < sizeof requests / sizeof *requests; i++)
        if (requests[i].id == id) c->notices->requests |= requests[i].request;
    return BAT_OK;
}
