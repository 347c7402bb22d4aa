/* CSS rules are found by their keys: for any sheet and any element, the same rules in the same order as by testing
 * every rule. Selectors with descendants and children match as trying all ancestors does; sheets for the screen and
 * variables count. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "format/svg/style.h"
#include "format/svg/tree.h"
#include "support/alloc_fail.h"
#include "support/xml.h"
#include <stdio.h>
#include <string.h>

static unsigned next_random(unsigned *state) {
    *state = *state * 1664525u + 1013904223u;
    return *state >> 16;
}

static const char *const words[] = {"a", "b", "ab", "abc", "path", "g", "B", "a-b"};
enum { WORDS = sizeof words / sizeof *words };

static void add_selector(char *sheet, size_t room, unsigned *state) {
    static const char *const marks[] = {"", ".", "#", "."};
    size_t at = strlen(sheet);
    if (next_random(state) % 9 == 0) {
        snprintf(sheet + at, room - at, "*");
        return;
    }
    for (unsigned i = 0, parts = 1 + next_random(state) % 3; i < parts; i++) {
        const char *mark = marks[i ? 1 + next_random(state) % 3 : next_random(state) % 4];
        at = strlen(sheet);
        snprintf(sheet + at, room - at, "%s%s", mark, words[next_random(state) % WORDS]);
    }
}

static const char *word_or_none(unsigned *state) {
    unsigned which = next_random(state) % (WORDS + 1);
    return which < WORDS ? words[which] : NULL;
}

/* A tree of some elements, each within one of those before it. */
static void make_tree(bat_svg_tree *tree, unsigned *state) {
    *tree = (bat_svg_tree){0};
    int depth = 0;
    for (int element = 0; element < 20; element++) {
        char classes[40];
        const char *type = words[next_random(state) % WORDS], *id = word_or_none(state);
        const char *first = words[next_random(state) % WORDS], *second = words[next_random(state) % WORDS];
        snprintf(classes, sizeof classes, " %s  %s", first, second);
        const char *given[5] = {NULL};
        int at = 0;
        if (id) given[at++] = "id", given[at++] = id;
        if (element % 4) given[at++] = "class", given[at++] = classes;
        while (depth > 1 && next_random(state) % 3 == 0) {
            assert_int_equal(bat_svg_tree_close(tree), BAT_OK);
            depth--;
        }
        assert_int_equal(bat_svg_tree_open(tree, type, given), BAT_OK);
        depth++;
    }
    while (depth-- > 0) assert_int_equal(bat_svg_tree_close(tree), BAT_OK);
}

/* Whether the compound, as these tests write it, matches. */
static bool compound_is(const bat_svg_tree *tree, uint32_t element, const char *text, size_t size) {
    static const char *const empty = "";
    const char *id = bat_svg_tree_attribute(tree, element, "id"),
               *classes = bat_svg_tree_attribute(tree, element, "class");
    if (size == 1 && *text == '*') return true;
    for (size_t at = 0; at < size;) {
        char mark = text[at] == '.' || text[at] == '#' ? text[at++] : ' ', name[20], within[60], both[60];
        size_t n = 0;
        while (at + n < size && text[at + n] != '.' && text[at + n] != '#') n++;
        snprintf(name, sizeof name, "%.*s", (int)n, text + at);
        snprintf(within, sizeof within, "%s ", classes ? classes : empty);
        snprintf(both, sizeof both, " %s ", name);
        const bool good = mark == '.'   ? strstr(within, both) != NULL
                          : mark == '#' ? id && !strcmp(id, name)
                                        : !strcmp(bat_svg_tree_name(tree, element), name);
        if (!good) return false;
        at += n;
    }
    return true;
}

static uint32_t sibling_before(const bat_svg_tree *tree, uint32_t element) {
    uint32_t at = tree->elements[tree->elements[element].parent].first;
    if (at == element || element == 1) return 0;
    while (tree->elements[at].next != element) at = tree->elements[at].next;
    return at;
}

/* By trying every ancestor and sibling: compounds 0 to last of the selector, the last at the element. */
static bool matches_by_trying(const bat_svg_tree *tree, uint32_t element, const char *const *parts,
                              const char *joints, int last) {
    if (!element || !compound_is(tree, element, parts[last], strlen(parts[last]))) return false;
    if (last == 0) return true;
    const bool beside = joints[last] == '~' || joints[last] == '+';
    for (uint32_t at = element;;) {
        at = beside ? sibling_before(tree, at) : tree->elements[at].parent;
        if (!at) return false;
        if (matches_by_trying(tree, at, parts, joints, last - 1)) return true;
        if (joints[last] == '>' || joints[last] == '+') return false;
    }
}

static void all_rules_that_match_are_found(void **unused) {
    (void)unused;
    unsigned state = 5;
    long steps = 0;
    bat_svg_candidates candidates = {0};
    for (int round = 0; round < 300; round++) {
        char text[2000] = "";
        bat_svg_sheet sheet;
        bat_svg_tree tree;
        for (unsigned i = next_random(&state) % 30; i > 0; i--) {
            static const char *const joints[] = {" ", ">", " > ", "~", " + "};
            for (unsigned more = next_random(&state) % 3; more > 0; more--) {
                add_selector(text, sizeof text, &state);
                strcat(text, joints[next_random(&state) % 5]);
            }
            add_selector(text, sizeof text, &state);
            strcat(text, i % 3 ? "{fill:red}" : ",");
        }
        strcat(text, ".z{}");
        assert_int_equal(bat_svg_sheet_parse(text, strlen(text), &sheet), BAT_OK);
        make_tree(&tree, &state);
        for (uint32_t element = 1; element < tree.count; element++) {
            assert_int_equal(bat_svg_candidates_find(&sheet, &tree, element, &candidates), BAT_OK);
            size_t at = 0;
            for (size_t i = 0; i < sheet.count; i++) {
                if (!bat_svg_rule_matches(&sheet, &sheet.rules[i], &tree, element, &steps)) continue;
                while (at < candidates.count && candidates.rules[at] < i) at++;
                assert_true(at < candidates.count && candidates.rules[at] == i);
            }
            for (size_t i = 1; i < candidates.count; i++)
                assert_true(candidates.rules[i - 1] < candidates.rules[i]);
        }
        bat_svg_tree_free(&tree);
        bat_svg_sheet_free(&sheet);
    }
    bat_svg_candidates_free(&candidates);
}

/* Every rule that matches is a candidate, in order; of rules about other values hardly any is. */
static void rules_about_attributes_are_found(void **unused) {
    (void)unused;
    static const char *const tests[] = {"=", "~=", "^=", "$=", "*=", ""};
    unsigned state = 11;
    long steps = 0;
    size_t matched = 0, tried = 0;
    bat_svg_candidates candidates = {0};
    for (int round = 0; round < 300; round++) {
        char text[6000] = ".z{}";
        bat_svg_sheet sheet;
        bat_svg_tree tree;
        for (unsigned i = next_random(&state) % 40; i > 0; i--) {
            const char *name = next_random(&state) % 2 ? "class" : "id",
                       *test = tests[next_random(&state) % 6];
            const char *word = words[next_random(&state) % WORDS],
                       *quote = next_random(&state) % 2 ? "'" : "";
            const size_t at = strlen(text);
            if (next_random(&state) % 2) add_selector(text, sizeof text, &state);
            snprintf(text + strlen(text), sizeof text - strlen(text),
                     *test ? "[%s%s%s%s%s]{fill:red}" : "[%s]{fill:red}", name, test, quote, word, quote);
            assert_true(strlen(text) > at);
        }
        assert_int_equal(bat_svg_sheet_parse(text, strlen(text), &sheet), BAT_OK);
        make_tree(&tree, &state);
        for (uint32_t element = 1; element < tree.count; element++) {
            assert_int_equal(bat_svg_candidates_find(&sheet, &tree, element, &candidates), BAT_OK);
            size_t at = 0;
            tried += candidates.count;
            for (size_t i = 0; i < sheet.count; i++) {
                if (!bat_svg_rule_matches(&sheet, &sheet.rules[i], &tree, element, &steps)) continue;
                while (at < candidates.count && candidates.rules[at] < i) at++;
                assert_true(at < candidates.count && candidates.rules[at] == i);
                matched++;
            }
        }
        bat_svg_tree_free(&tree);
        bat_svg_sheet_free(&sheet);
    }
    bat_svg_candidates_free(&candidates);
    assert_true(matched > 1000 && tried < 3 * matched);
}

static void elements_are_found_as_by_trying_all(void **unused) {
    (void)unused;
    unsigned state = 9;
    long steps = 0;
    int found = 0, tried = 0;
    for (int round = 0; round < 400; round++) {
        char text[300] = "", pieces[4][60], joints[4];
        const char *parts[4];
        bat_svg_sheet sheet;
        bat_svg_tree tree;
        const int count = 2 + (int)(next_random(&state) % 3);
        for (int i = 0; i < count; i++) {
            pieces[i][0] = '\0';
            if (next_random(&state) % 2)
                strcpy(pieces[i], "*");
            else
                snprintf(pieces[i], sizeof pieces[i], ".%s", words[next_random(&state) % WORDS]);
            joints[i] = " >~+"[next_random(&state) % 4];
            if (i > 0) strncat(text, &joints[i], 1);
            strcat(text, pieces[i]);
            parts[i] = pieces[i];
        }
        strcat(text, "{fill:red}");
        assert_int_equal(bat_svg_sheet_parse(text, strlen(text), &sheet), BAT_OK);
        assert_int_equal(sheet.count, 1);
        make_tree(&tree, &state);
        for (uint32_t element = 1; element < tree.count; element++, tried++) {
            const bool now = bat_svg_rule_matches(&sheet, sheet.rules, &tree, element, &steps);
            if (now != matches_by_trying(&tree, element, parts, joints, count - 1))
                fail_msg("%s at element %u: %d", text, (unsigned)element, now);
            found += now;
        }
        bat_svg_tree_free(&tree);
        bat_svg_sheet_free(&sheet);
    }
    assert_in_range(found, tried / 20, tried / 2);
}

/* The fill of the last object of a drawing with this style sheet and content. */
static uint32_t fill_of(const char *css, const char *content) {
    char text[1500];
    bat_document *document = NULL;
    bat_svg_report report;
    bat_problem problem = {"", ""};
    snprintf(text, sizeof text,
             "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9'><style>%s</style>%s</svg>", css,
             content);
    if (xml_read(text, NULL, &document, &report, &problem) != BAT_OK)
        fail_msg("%s: %s", problem.message, text);
    const bat_object *last = bat_document_at(document, bat_document_count(document) - 1);
    const bat_style *style = last ? bat_object_style(last) : NULL;
    const uint32_t fill = style && style->filled ? style->fill : 0;
    bat_document_free(document);
    return fill;
}

#define BOX "<rect class='b c' id='i' width='5' height='5' data-k='one two' "
static const char WITHIN[] = "<g class='a' id='o'><g>" BOX "/></g></g>";

/* Expected by the words of Selectors 4 and of CSS Cascade, Media Queries and Custom Properties. */
static void styles_apply_as_css_says(void **unused) {
    (void)unused;
    static const struct {
        const char *css, *content;
        uint32_t fill;
    } cases[] = {
        {".a rect{fill:#f00}", WITHIN, 0xff0000ff},
        {".a>rect{fill:#f00}", WITHIN, 0x000000ff},
        {".a > g > rect{fill:#f00}", WITHIN, 0xff0000ff},
        {"#o .b.c{fill:#f00}.b.c{fill:#0f0}", WITHIN, 0xff0000ff}, /* the specificities add up */
        {"g rect{fill:#f00}g g rect{fill:#00f}rect{fill:#0f0}", WITHIN, 0x0000ffff},
        {"svg .c{fill:#f00}", WITHIN, 0xff0000ff},
        {":root{fill:#f00}", WITHIN, 0xff0000ff}, /* inherited */
        {"rect:not(.z){fill:#f00}", WITHIN, 0xff0000ff},
        {"rect:not(.b){fill:#f00}", WITHIN, 0x000000ff},
        {"rect:not( #i ){fill:#f00}", WITHIN, 0x000000ff},
        {"rect:not([fill]){fill:#f00}", WITHIN, 0xff0000ff},
        {"[id]{fill:#f00}", WITHIN, 0xff0000ff},
        {"[data-k=\"one two\"]{fill:#f00}", WITHIN, 0xff0000ff},
        {"[data-k~=two]{fill:#f00}", WITHIN, 0xff0000ff},
        {"[data-k^=two]{fill:#f00}", WITHIN, 0x000000ff},
        {"[data-k$='wo']{fill:#f00}", WITHIN, 0xff0000ff},
        {"[data-k*='e t']{fill:#f00}", WITHIN, 0xff0000ff},
        {"[data-k='a,b'],rect{fill:#f00}", WITHIN, 0xff0000ff}, /* the comma in quotes ends nothing */
        {"g:first-child>rect:last-child{fill:#f00}", WITHIN, 0xff0000ff},
        {"rect:only-child{fill:#f00}", WITHIN, 0xff0000ff},
        {"rect:only-child{fill:#f00}", BOX "/><circle r='1'/>", 0x000000ff},
        {"rect:only-of-type{fill:#f00}", "<circle r='1'/>" BOX "/>", 0xff0000ff},
        {"rect:first-of-type{fill:#f00}", "<circle r='1'/><title>t</title>" BOX "/>", 0xff0000ff},
        {"rect:last-of-type{fill:#f00}", BOX "/><circle r='1'/>" BOX "/>", 0xff0000ff},
        {"rect:nth-of-type(2){fill:#f00}", "<circle r='1'/>" BOX "/><circle r='1'/>" BOX "/>", 0xff0000ff},
        {"rect:nth-of-type(1){fill:#f00}", "<circle r='1'/>" BOX "/><circle r='1'/>" BOX "/>", 0x000000ff},
        {"rect:nth-last-of-type( 1 ){fill:#f00}", BOX "/>" BOX "/>", 0xff0000ff},
        {"rect:nth-child(2n + 1){fill:#f00}", "<g><circle r='1'/><circle r='2'/>" BOX "/></g>", 0xff0000ff},
        {"rect:nth-child(even){fill:#f00}", "<g><circle r='1'/><circle r='2'/>" BOX "/></g>", 0x000000ff},
        {"rect:nth-child(-n+2){fill:#f00}", "<g><circle r='1'/><circle r='2'/>" BOX "/></g>", 0x000000ff},
        {"rect:nth-child(-n+3){fill:#f00}", "<g><circle r='1'/><circle r='2'/>" BOX "/></g>", 0xff0000ff},
        {"rect:nth-child(3n-3),rect:nth-child(n+4){fill:#f00}", "<g><circle r='1'/><path/>" BOX "/></g>",
         0xff0000ff},
        {"rect:nth-last-child(0n+1){fill:#f00}", "<g><circle r='1'/>" BOX "/></g>", 0xff0000ff},
        {"rect:nth-child(),rect:nth-child(x),rect:nth-child(2n+),rect:first-child(1){fill:#f00}", BOX "/>",
         0x000000ff},
        {":is(circle, rect.b):is(:root, *){fill:#f00}", WITHIN, 0xff0000ff},
        {":where(#i){fill:#f00}rect{fill:#00f}", WITHIN, 0x0000ffff}, /* it weighs nothing */
        {":is(#i,x){fill:#f00}rect{fill:#00f}", WITHIN, 0xff0000ff},
        {"rect:not(circle, :nth-child(3), :hover){fill:#f00}", WITHIN, 0xff0000ff},
        {"rect:not(circle, :nth-child(1)){fill:#f00}", WITHIN, 0x000000ff},
        {"rect:hover{fill:#f00}rect::before{fill:#f00}", WITHIN, 0x000000ff},
        {"g:has(rect) rect,rect:lang(en){fill:#f00}", WITHIN,
         0x000000ff}, /* they may match: said, not obeyed */
        {"rect+rect{fill:#f00}", BOX "/>" BOX "/>", 0xff0000ff},
        {"rect+rect{fill:#f00}", BOX "/>", 0x000000ff},
        {"circle+rect{fill:#f00}", "<circle r='1'/><path d='M0 0h1'/>" BOX "/>", 0x000000ff},
        {"circle ~ rect{fill:#f00}", "<circle r='1'/><path d='M0 0h1'/>" BOX "/>", 0xff0000ff},
        {"circle~rect{fill:#f00}", "<g><circle r='1'/></g>" BOX "/>", 0x000000ff},
        {"g>circle+path ~ .b{fill:#f00}",
         "<g><circle r='1'/><path d='M0 0h1'/><path d='M0 0h1'/>" BOX "/></g>", 0xff0000ff},
        {"svg + rect,rect++rect,rect~+rect,rect+{fill:#f00}", BOX "/>" BOX "/>", 0x000000ff},
        {"rect>{fill:#f00}>rect{fill:#f00}", WITHIN, 0x000000ff},
        {"@media screen{rect{fill:#f00}}", WITHIN, 0xff0000ff},
        {"@media print, screen{rect{fill:#f00}}", WITHIN, 0xff0000ff},
        {"@media print{rect{fill:#f00}}", WITHIN, 0x000000ff},
        {"@media not screen{rect{fill:#f00}}", WITHIN, 0x000000ff},
        {"@media screen{g{opacity:1}rect{fill:#f00}}.b{stroke:#000}", WITHIN, 0xff0000ff},
        {"@media screen and (max-width:1px){rect{fill:#f00}}rect{fill:#00f}", WITHIN, 0x0000ffff},
        {":root{--x:#f00}rect{fill:var(--x)}", WITHIN, 0xff0000ff},
        {":root{--x:#f00}.a{--x: #0f0 }rect{fill:var( --x )}", WITHIN, 0x00ff00ff},
        {"rect{fill:var(--x);--x:#f00}", WITHIN, 0xff0000ff}, /* the order does not matter */
        {"rect{fill:var(--x,#00f)}", WITHIN, 0x0000ffff},
        {"rect{fill:var(--x,var(--y,#00f))}", WITHIN, 0x0000ffff},
        {":root{--x:var(--y);--y:#f00}rect{fill:var(--x)}", WITHIN, 0xff0000ff},
        {":root{--x:var(--y);--y:var(--x)}rect{fill:var(--x)}", WITHIN, 0x000000ff},
        {".a{fill:#f00}rect{fill:var(--none)}", WITHIN, 0xff0000ff}, /* invalid: inherited */
        {".a{--x:#f00}", "<g class='a'>" BOX "fill='var(--x)'/></g>", 0xff0000ff},
        {"", "<g style='--x:#f00'>" BOX "style='fill:var(--x)'/></g>", 0xff0000ff},
        {"", "<g style='--x:#f00'/>" BOX "style='fill:var(--x,#0f0)'/>", 0x00ff00ff}, /* not beside it */
        {".a{color:#f00}rect{color:currentColor;fill:currentColor}", WITHIN, 0xff0000ff},
        {"rect{fill:var(--x}", WITHIN, 0x000000ff},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const uint32_t fill = fill_of(cases[i].css, cases[i].content);
        if (fill != cases[i].fill)
            fail_msg("%s: %08x, expected %08x", cases[i].css, (unsigned)fill, (unsigned)cases[i].fill);
    }
}

static void memory_may_run_out(void **unused) {
    (void)unused;
    static const char text[] =
        "<svg xmlns='http://www.w3.org/2000/svg'><style>:root{--x:#f00;--y:2}.a>*{fill:var(--x)}"
        "</style><g class='a' style='--x:#0f0'><rect width='5' height='5'/></g></svg>";
    int failed = 0;
    for (int n = 1; n < 500; n++) {
        const long before = alloc_live();
        bat_document *document = NULL;
        bat_svg_report report;
        bat_problem problem = {"", ""};
        alloc_fail_at(n);
        const bat_status status = xml_read(text, NULL, &document, &report, &problem);
        const bool reached = alloc_fail_reached();
        alloc_fail_at(0);
        if (status == BAT_OK)
            assert_int_equal(bat_object_style(bat_document_at(document, 0))->fill, 0x00ff00ff);
        if (status != BAT_OK) assert_int_equal(status, BAT_MEMORY);
        bat_document_free(document);
        assert_int_equal(alloc_live(), before);
        if (!reached) break;
        failed += status == BAT_MEMORY;
    }
    assert_in_range(failed, 10, 490);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_rules_that_match_are_found),
        cmocka_unit_test(elements_are_found_as_by_trying_all), cmocka_unit_test(styles_apply_as_css_says),
        cmocka_unit_test(rules_about_attributes_are_found), cmocka_unit_test(memory_may_run_out)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
