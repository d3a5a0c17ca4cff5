-- What docs/explanation/benchmark.md says under "What it can be trusted with": what is counted, how many, of how many.
--   sqlite3 -init experiments/benchmark/figures/views.sql reporting.db < experiments/benchmark/figures/trust.sql
CREATE TEMP TABLE answer AS SELECT * FROM judged WHERE set_name = 'reporting' AND made;
CREATE TEMP TABLE found AS SELECT * FROM answer JOIN law_found USING (version, set_name, number) WHERE kind = 'one';
CREATE TEMP TABLE stated AS
SELECT v.is_right, v.verdict, v.probability, a.form FROM verdict_right v JOIN answer a USING (version, set_name, number)
WHERE v.verdict <> 'cannot_tell' AND v.probability IS NOT NULL;
CREATE TEMP TABLE ended AS
SELECT a.form, l.true_set, coalesce(h.square <= 1.1 * 1.1, 0) AS predicts
FROM answer a JOIN loop_end l USING (version, set_name, number) JOIN held_out_ratio h USING (version, set_name, number)
WHERE a.kind IN ('one', 'two') AND (version, set_name, number) NOT IN (SELECT version, set_name, number FROM cut_short);
CREATE TEMP TABLE covered AS
SELECT a.kind, i.of_effect AS effect, i.truth BETWEEN i.lower AND i.upper AS holds
FROM answer a JOIN effect_interval i USING (version, set_name, number) WHERE a.kind IN ('one', 'two');
CREATE TEMP TABLE named AS
SELECT count(*) AS effects FROM reported r JOIN answer a USING (version, set_name, number)
WHERE a.kind = 'one' AND r.round = 1 GROUP BY version, number;

.mode list
.separator ' | '
SELECT 'answers, different cases', count(*), count(DISTINCT number) FROM answer;
SELECT 'of ' || version, count(*), '' FROM answer GROUP BY version;
SELECT 'nothing hidden: answers, different cases', count(*), count(DISTINCT number) FROM answer WHERE kind = 'nothing';
SELECT 'nothing hidden: false alarms', sum(verdict IN ('effect_found', 'not_in_library')), count(*)
FROM answer WHERE kind = 'nothing';
SELECT 'nothing hidden: false alarms without contacts', sum(verdict IN ('effect_found', 'not_in_library')), count(*)
FROM answer WHERE kind = 'nothing' AND group_name <> 'contact';
SELECT 'nothing hidden: cannot_tell', sum(verdict = 'cannot_tell'), count(*) FROM answer WHERE kind = 'nothing';
SELECT 'something hidden: nothing_missing', sum(verdict = 'nothing_missing'), count(*) FROM answer WHERE kind <> 'nothing';
SELECT 'one hidden: named, or like it', sum(named_alike), count(*) FROM found;
SELECT 'one hidden: named, and nothing that could be told from it', sum(named AND others = 0), count(*) FROM found;
SELECT 'one hidden: effects an effect_found names, mean, most', round(avg(effects), 1), max(effects) FROM named;
SELECT 'one hidden: effect_found that names one alone', sum(effects = 1), count(*) FROM named;
SELECT 'one hidden: more than one added, ' || form, sum(n > 1), count(*)
FROM (SELECT form, (SELECT count(*) FROM added_effect x
                    WHERE (x.version, x.set_name, x.number) = (a.version, a.set_name, a.number)) AS n
      FROM answer a WHERE kind = 'one') GROUP BY form;
SELECT 'the loop ends at the true set, ' || form, sum(true_set), count(*) FROM ended GROUP BY form;
SELECT 'held out within a tenth, true set ' || iif(true_set, '', 'not ') || 'reached, ' || form, sum(predicts), count(*)
FROM ended GROUP BY form, true_set;
SELECT 'intervals of values, ' || a.form, sum(truth BETWEEN lower AND upper), count(*)
FROM value_interval JOIN answer a USING (version, set_name, number) GROUP BY a.form;
SELECT 'intervals of effects', sum(holds), count(*) FROM covered;
SELECT 'intervals of effects, two hidden', sum(holds), count(*) FROM covered WHERE kind = 'two';
SELECT 'intervals of ' || effect, sum(holds), count(*) FROM covered GROUP BY effect HAVING count(*) >= 9
ORDER BY avg(holds);
SELECT 'effect_found right, stated ' || band, sum(is_right), count(*)
FROM (SELECT is_right, CASE WHEN probability < 0.7 THEN 'below 0.7' WHEN probability < 0.9 THEN '0.7 to 0.9'
                            ELSE '0.9 and more' END AS band FROM stated WHERE verdict = 'effect_found')
GROUP BY band ORDER BY band DESC;
SELECT 'effect_found: mean stated, share right, ' || form, round(avg(probability), 2), round(avg(is_right), 2)
FROM stated WHERE verdict = 'effect_found' AND form <> 'nothing' GROUP BY form;
SELECT 'withheld: not_in_library', sum(verdict = 'not_in_library'), count(*) FROM answer WHERE kind = 'withheld';
SELECT 'not_in_library: right', sum(is_right), count(*) FROM stated WHERE verdict = 'not_in_library';
SELECT 'not_in_library: mean stated', round(avg(probability), 2), count(*) FROM stated WHERE verdict = 'not_in_library';
SELECT 'contacts, ' || rig, count(*), '' FROM answer WHERE group_name = 'contact' GROUP BY rig;
