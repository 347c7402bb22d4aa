#include "format/model/zip.h"

#include "format/model/floats.h"

#include <string.h>

enum { FILE_AT = 0x04034B50, ENTRY_AT = 0x02014B50, END_AT = 0x06054B50 };
enum { VERSION = 20, FIRST_DAY = 0x21 }; /* 2.0; 1980-01-01 */

/* Four bits at a time. */
uint32_t bat_zip_check(const char *bytes, size_t size) {
    static const uint32_t table[16] = {0x00000000, 0x1DB71064, 0x3B6E20C8, 0x26D930AC, 0x76DC4190, 0x6B6B51F4,
                                       0x4DB26158, 0x5005713C, 0xEDB88320, 0xF00F9344, 0xD6D6A3E8, 0xCB61B38C,
                                       0x9B64C2B0, 0x86D3D2D4, 0xA00AE278, 0xBDBDF21C};
    uint32_t sum = 0xFFFFFFFF;
    for (size_t i = 0; i < size; i++) {
        sum ^= (unsigned char)bytes[i];
        sum = sum >> 4 ^ table[sum & 15];
        sum = sum >> 4 ^ table[sum & 15];
    }
    return ~sum;
}

static void put_half(bat_text *text, uint32_t half) {
    const char bytes[2] = {(char)(half & 255), (char)(half >> 8 & 255)};
    bat_text_add(text, bytes, 2);
}

/* What an entry of the list and the file itself have in common. */
static void put_head(bat_zip *zip, int i) {
    const uint32_t length = (uint32_t)strlen(zip->file[i].name);
    const uint32_t halves[] = {VERSION, 0, 0, 0, FIRST_DAY};
    for (int k = 0; k < 5; k++) put_half(&zip->bytes, halves[k]);
    bat_text_word(&zip->bytes, zip->file[i].check);
    bat_text_word(&zip->bytes, zip->file[i].size);
    bat_text_word(&zip->bytes, zip->file[i].size);
    put_half(&zip->bytes, length);
    put_half(&zip->bytes, 0);
}

void bat_zip_add(bat_zip *zip, const char *name, const char *bytes, size_t size) {
    const int i = zip->count++;
    zip->file[i].name = name;
    zip->file[i].check = bat_zip_check(bytes, size);
    zip->file[i].size = (uint32_t)size;
    zip->file[i].at = (uint32_t)zip->bytes.size;
    bat_text_word(&zip->bytes, FILE_AT);
    put_head(zip, i);
    bat_text_string(&zip->bytes, name);
    bat_text_add(&zip->bytes, bytes, size);
}

bat_status bat_zip_finish(bat_zip *zip, char **bytes, size_t *size) {
    const size_t from = zip->bytes.size;
    for (int i = 0; i < zip->count; i++) {
        bat_text_word(&zip->bytes, ENTRY_AT);
        put_half(&zip->bytes, VERSION);
        put_head(zip, i);
        for (int k = 0; k < 3; k++) put_half(&zip->bytes, 0);
        bat_text_word(&zip->bytes, 0);
        bat_text_word(&zip->bytes, zip->file[i].at);
        bat_text_string(&zip->bytes, zip->file[i].name);
    }
    const size_t end = zip->bytes.size;
    bat_text_word(&zip->bytes, END_AT);
    bat_text_word(&zip->bytes, 0);
    put_half(&zip->bytes, (uint32_t)zip->count);
    put_half(&zip->bytes, (uint32_t)zip->count);
    bat_text_word(&zip->bytes, (uint32_t)(end - from));
    bat_text_word(&zip->bytes, (uint32_t)from);
    put_half(&zip->bytes, 0);
    if (!zip->bytes.failed && zip->bytes.size > UINT32_MAX) {
        bat_text_free(&zip->bytes);
        return BAT_TOLERANCE;
    }
    return bat_text_finish(&zip->bytes, bytes, size);
}
